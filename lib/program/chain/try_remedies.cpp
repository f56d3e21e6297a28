#include "chain/try_remedies.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <tuple>

#include "base/tolerance.hpp"
#include "chain/chain_inputs.hpp"
#include "chain/chain_nodes.hpp"
#include "chain/make_graph.hpp"
#include "curve/symmetry_lines.hpp"
#include "mesh/verdict.hpp"
#include "model/name_rules.hpp"
#include "stage/symmetry_option.hpp"
#include "topology/fewest_nodes.hpp"
#include "topology/grid_kind.hpp"

namespace quadrille::chain {

namespace {

/// Words for critpoints, such as "--ties", "field".
using Remedy = std::vector<std::string>;

std::string options_text(const Remedy& remedy) { return fmt::format("critpoints {}", fmt::join(remedy, " ")); }

std::vector<Remedy> remedies_of(const io::StageReport& report) {
  std::vector<Remedy> remedies;
  if (io::value_of(report, "certificate.method") != "midpoint") return remedies;
  for (const char* key : {"quantize.remedies", "other_grids"}) {
    const std::string text = io::value_of(report, key).value_or("");
    for (std::size_t begin = 0; begin < text.size();) {
      const std::size_t end = std::min(text.find(", ", begin), text.size());
      const std::string one = text.substr(begin, end - begin);
      remedies.push_back({one.substr(0, one.find(' ')), one.substr(one.find(' ') + 1)});
      begin = end + 2;
    }
  }
  return remedies;
}

void remove_files(NodeFiles& files) {
  std::error_code ignored;
  for (const std::string& path : {files.nodes.path(), files.phase_solve.path(), files.phase.path(), files.graph.path(),
                                  files.blocks.path(), files.quads.path()})
    std::filesystem::remove(path, ignored);
}

template <typename Model>
bool exists(const StageFile<Model>& file) {
  return file.is_in_memory() || std::filesystem::exists(file.path());
}

template <typename Model>
void replace(StageFile<Model>& file, StageFile<Model>& other) {
  std::error_code ignored;
  std::filesystem::remove(file.path(), ignored);
  std::filesystem::rename(other.path(), file.path(), ignored);
  file.take(other);
}

/// The runs of the remedy count, those of the stages that it replaces do not.
void take_remedy(ChainState& chain, NodeFiles& files, const Remedy& remedy, std::size_t first_replaced,
                 std::size_t first_run) {
  std::vector<io::StageReport>& reports = chain.runner.reports();
  for (std::size_t i = first_replaced; i < reports.size(); ++i) {
    std::string& stage = reports[i].stage;
    const bool is_trial = stage.starts_with(prefix_of_trials);
    if (i < first_run && !is_trial) stage.insert(0, prefix_of_trials);
    if (i >= first_run && io::value_of(reports[i], "tool") != "quadrefine")
      stage = "remedy_" + stage.substr(std::string(prefix_of_trials).size());
  }
  NodeFiles& usual = chain.files.of_nodes;
  replace(usual.nodes, files.nodes);
  replace(usual.phase_solve, files.phase_solve);
  replace(usual.phase, files.phase);
  replace(usual.graph, files.graph);
  const bool has_blocks = exists(files.blocks);
  if (has_blocks) replace(usual.blocks, files.blocks);
  if (exists(files.quads)) replace(usual.quads, files.quads);
  chain.last = has_blocks ? usual.blocks.path() : usual.graph.path();
  chain.remedy = options_text(remedy);
  print_warnings(chain, first_run);
}

/// Makes the graph of the nodes of `files`. Returns false if no layout is traced or quantized: midpoint blocks do not
/// count.
bool make_layout(ChainState& chain, NodeFiles& files) {
  return make_graph(chain, files) && io::value_of(chain.runner.reports().back(), "certificate.method") != "midpoint";
}

bool gives_layout(ChainState& chain, NodeFiles& files, const Remedy& remedy) {
  chain.prefix = prefix_of_trials;
  const bool is_made = make_nodes(chain, files, remedy) && make_layout(chain, files);
  chain.prefix.clear();
  return is_made;
}

struct TrialLimits {
  double edge_ratio = 100;
  double scaled_jacobian = mesh::scaled_jacobian_limits.poor;
  double poor_resolution = 25;  ///< good meshes of far fields have 4 to 15
  double resolution = 2;        ///< outside far fields
  double gain = 0.95;           ///< of the resolution ratio
  std::size_t nodes = 24;       ///< of more, the least energy takes longer than all other stages
};
constexpr TrialLimits trial_limits;

/// What a mesh exceeds, the worst first.
std::array<bool, 4> faults_of(const io::LayoutTrial& trial) {
  return {!trial.is_valid, trial.edge_ratio > trial_limits.edge_ratio,
          trial_limits.scaled_jacobian > trial.scaled_jacobian, trial.resolution > trial_limits.poor_resolution};
}

bool has_faults(const io::LayoutTrial& trial) { return faults_of(trial) != std::array{false, false, false, false}; }

bool is_better(const io::LayoutTrial& a, const io::LayoutTrial& b) {
  const auto faults_a = faults_of(a), faults_b = faults_of(b);
  if (faults_a != faults_b) return faults_a < faults_b;
  if (a.resolution < trial_limits.gain * b.resolution) return true;
  return a.blocks < b.blocks && trial_limits.gain * a.resolution <= b.resolution;
}

/// In a far field sizes grow with the distance from the body while the number of elements around it stays: there a
/// resolution ratio above 2 is no reason for other nodes.
double good_resolution(const CadFace& face) {
  return has_far_field(face) ? trial_limits.poor_resolution : trial_limits.resolution;
}

/// Whether trials are the meshes of quadrefine without options. On surfaces and in far fields these take longer, and
/// the limits are for coarser ones.
bool has_whole_trials(const CadFace& face) { return !face.chart && !has_far_field(face); }

stage::QuadrefineOptions trial_options(const ChainState& chain, const CadFace& face) {
  stage::QuadrefineOptions options;
  options.align_strength = chain.values.quadrefine.align_strength;
  options.symmetry = chain.values.quadrefine.symmetry;
  options.is_trial = true;
  if (has_whole_trials(face)) return options;
  options.refine.order = 2;
  options.refine.least_progress = refine::coarse_progress;
  options.refine.keeps_to_surface = false;
  options.refine.rings = refine::Rings::none;
  return options;
}

/// Whether the meshes of trials are those of the run.
bool makes_trials(const ChainState& chain, const CadFace& face) {
  return has_whole_trials(face) && chain.is_due(ChainStage::quadrefine) &&
         chosen_words(chain, ChainStage::quadrefine).empty();
}

/// Makes a trial mesh and appends its figures to chain.trials. Returns false if there is no mesh.
bool try_mesh(ChainState& chain, NodeFiles& files, const std::string& options) {
  const std::string last = chain.last;
  const CadFace& face = files.nodes.model().face;
  const auto quads = [&](Run& run) {
    const auto directions = directions_to_align_with(chain);
    return stage::quadrefine({files.blocks.input(), {}, {}, directions.input()}, trial_options(chain, face), run);
  };
  StageFile<QuadMesh> other(chain.runner.scratch() + "/trial.quad.h5");
  StageFile<QuadMesh>& mesh = makes_trials(chain, face) ? files.quads : other;
  const bool is_made = make_file(chain, {ChainStage::quadrefine}, mesh, quads, files.blocks);
  chain.last = last;
  if (!is_made) return false;
  chain.trials.push_back(io::layout_trial(chain.runner.reports().back(), options));
  return true;
}

/// Whether this run finds nodes and blocks, and the user left the choice of nodes to it.
bool may_try_nodes(ChainState& chain) {
  const ChainOptions& options = chain.options;
  return !chain.has_fixed_nodes && !options.is_dry_run && chain.has_other_way && chain.remedy.empty() &&
         options.programs.empty() && chain.values.quadrefine.walls.empty() && chain.num_nodes > 0 &&
         chain.num_nodes <= trial_limits.nodes && chain.is_due(ChainStage::critpoints) &&
         chain.is_due(ChainStage::blocksplit) && !options.has("critpoints", "--place") &&
         !options.has("critpoints", "--nodes");
}

bool are_same_nodes(const CriticalPoints& a, const CriticalPoints& b) {
  return std::ranges::equal(a.critical_points, b.critical_points, [&](const CriticalPoint& p, const CriticalPoint& q) {
    return p.valence == q.valence && distance(p.position, q.position) <= tolerance::same_point * a.face.diameter;
  });
}

/// Other nodes, and the meshes for which they are tried.
struct OtherNodes {
  Remedy remedy;
  bool (*is_for)(const io::LayoutTrial& best, double good);
};

/// It moves the nodes of the field: where they are not in use, they have made a worse mesh.
bool is_uneven(const io::LayoutTrial& best, double good) {
  return has_faults(best) || (best.options.empty() && best.resolution > good);
}
bool is_faulty(const io::LayoutTrial& best, double) { return has_faults(best); }
bool is_any(const io::LayoutTrial&, double) { return true; }

/// In a chart the field follows axes that turn on the surface, which makes pairs of nodes that no face needs.
std::vector<OtherNodes> other_nodes(ChainState& chain) {
  const TriMesh& mesh = chain.files.field.model().mesh;
  const CadFace& face = mesh.face;
  std::vector<OtherNodes> others{{{"--place", "energy"}, is_uneven}};
  if (!has_far_field(face) && topology::has_opposite_nodes(chain.files.of_nodes.nodes.model(), mesh.region_elems))
    others.insert(face.chart ? others.begin() : others.end(), {{"--nodes", "fewest"}, face.chart ? is_any : is_faulty});
  if (chain.options.has("critpoints", "--topology")) return others;
  for (const topology::GridKind grid :
       topology::other_grids(curve::whole_of(face, stage::symmetry_names(face, chain.values.quadrefine.symmetry))))
    others.push_back({{"--topology", std::string(enum_name(grid))}, is_faulty});
  return others;
}

/// Returns whether other nodes make a better mesh than `best`, and are taken.
bool try_nodes(ChainState& chain, const Remedy& remedy, std::size_t first_replaced, const io::LayoutTrial& best) {
  const auto before = std::tuple(chain.form, chain.num_nodes, chain.last);
  const std::size_t first_run = chain.runner.reports().size();
  NodeFiles files(chain.files.stem + ".remedy");
  if (make_nodes(chain, files, remedy) && !are_same_nodes(files.nodes.model(), chain.files.of_nodes.nodes.model()) &&
      make_layout(chain, files) && make_blocks(chain, files) && try_mesh(chain, files, options_text(remedy)) &&
      is_better(chain.trials.back(), best)) {
    if (chain.options.is_verbose) inform(chain, fmt::format("{} makes a better mesh", options_text(remedy)));
    take_remedy(chain, files, remedy, first_replaced, first_run);
    return true;
  }
  remove_files(files);
  std::tie(chain.form, chain.num_nodes, chain.last) = before;
  return false;
}

struct BestTrial {
  io::LayoutTrial trial;
  std::size_t run;  ///< its position among all
};

/// None if there is no mesh.
std::optional<BestTrial> best_trial(ChainState& chain, std::size_t first_replaced) {
  NodeFiles& usual = chain.files.of_nodes;
  const double good = good_resolution(usual.nodes.model().face);
  if (!try_mesh(chain, usual, {})) return std::nullopt;
  const auto last_trial = [&] { return BestTrial{chain.trials.back(), chain.runner.reports().size() - 1}; };
  BestTrial best = last_trial();
  for (const auto& [remedy, is_for] : other_nodes(chain)) {
    if (!is_for(best.trial, good)) continue;
    if (try_nodes(chain, remedy, first_replaced, best.trial)) best = last_trial();
    if (chain.given_up && chain.given_up->is_stopped) break;
    chain.given_up.reset();
  }
  return best;
}

/// The mesh of a trial becomes that of the chain, if it is one and valid.
bool keep_mesh(ChainState& chain, const BestTrial& best) {
  std::vector<io::StageReport>& reports = chain.runner.reports();
  NodeFiles& files = chain.files.of_nodes;
  if (!makes_trials(chain, files.nodes.model().face) || !best.trial.is_valid) return false;
  std::rotate(reports.begin() + best.run, reports.begin() + best.run + 1, reports.end());
  reports.back().stage = enum_name(ChainStage::quadrefine);
  chain.last = files.quads.path();
  print_warnings(chain, reports.size() - 1);
  return true;
}

}  // namespace

void try_remedies(ChainState& chain) {
  if (chain.has_fixed_nodes || chain.options.is_dry_run || !chain.has_other_way ||
      !chain.is_due(ChainStage::separatrix))
    return;
  const std::size_t replaced_run = chain.runner.reports().size() - 1;
  const auto before = std::tuple(chain.form, chain.num_nodes, chain.last);
  const std::vector<Remedy> remedies = remedies_of(chain.runner.reports()[replaced_run]);
  for (const Remedy& remedy : remedies) {
    if (chain.options.has("critpoints", remedy.front())) continue;
    inform(chain, fmt::format("no layout with these nodes: trying {}", options_text(remedy)));
    const std::size_t first_run = chain.runner.reports().size();
    NodeFiles files(chain.files.stem + ".remedy");
    if (gives_layout(chain, files, remedy)) {
      take_remedy(chain, files, remedy, replaced_run, first_run);
      return;
    }
    remove_files(files);
    if (chain.given_up && chain.given_up->is_stopped) {
      print_stop(chain);
      chain.has_other_way = false;
      break;
    }
  }
  chain.given_up.reset();
  std::tie(chain.form, chain.num_nodes, chain.last) = before;
}

bool try_better_nodes(ChainState& chain) {
  if (!may_try_nodes(chain)) return false;
  const std::vector<io::StageReport>& reports = chain.runner.reports();
  const auto first_replaced = std::ranges::find(reports, std::string("separatrix"), &io::StageReport::stage);
  if (first_replaced == reports.end() || io::value_of(*first_replaced, "certificate.method") == "midpoint")
    return false;
  chain.prefix = prefix_of_trials;
  const std::optional<BestTrial> best = best_trial(chain, first_replaced - reports.begin());
  chain.prefix.clear();
  // The report of a stage that was stopped says that the quads are made without a field; here the nodes stay.
  if (chain.given_up && chain.given_up->is_stopped) chain.runner.reports().pop_back();
  chain.given_up.reset();
  return best && keep_mesh(chain, *best);
}

}  // namespace quadrille::chain
