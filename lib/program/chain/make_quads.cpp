#include "chain/make_quads.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <tuple>

#include "chain/chain_inputs.hpp"
#include "chain/chain_nodes.hpp"
#include "cli/messages.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::chain {

namespace {

/// The field that has prescribed nodes.
bool solve_phase(ChainState& chain, NodeFiles& files) {
  StageFile<TriMesh>& triangles = chain.files.triangles;
  StageFile<Field>& field = chain.files.field;
  const auto solve = [&](Run& run) {
    const OrderMap orders{field.model().elem_order, field.model().kind == FieldKind::harmonic};
    stage::FieldsolveInput input{triangles.input(), {}, "field", {}};
    input.orders.emplace(orders, field.input().file);
    input.nodes.emplace(files.nodes.input());
    return stage::fieldsolve(input, chain.values.fieldsolve, run);
  };
  const auto adapt = [&](Run& run) { return stage::padapt(files.phase_solve.input(), chain.values.padapt, run); };
  const std::vector<std::string> words{"--nodes", files.nodes.name(), "--orders", field.path(), triangles.path()};
  const bool is_solved = make_file(chain, {ChainStage::fieldsolve, true, words}, files.phase_solve, solve, triangles,
                                   field, files.nodes) &&
                         make_file(chain, {ChainStage::padapt, true}, files.phase, adapt, files.phase_solve);
  files.phase_solve.forget();
  return is_solved;
}

/// With --dry-run, for a person: whether they run depends on what critpoints finds.
void print_phase_stages(ChainState& chain, NodeFiles& files) {
  if (!chain.is_due(ChainStage::separatrix)) return;
  cli::print_to_stdout(
      fmt::format("# if \"form\" is \"phase\" in {}, or its nodes were edited; separatrix then reads {}:\n",
                  files.nodes.name(), files.phase.path()));
  const std::string before = chain.last;
  chain.comment = "# ";
  solve_phase(chain, files);
  chain.comment.clear();
  chain.last = before;
}

bool trace(ChainState& chain, NodeFiles& files, StageFile<Field>& field) {
  const auto graph = [&](Run& run) {
    return stage::separatrix(field.input(), files.nodes.input(), layout_options(chain), run);
  };
  return make_file(chain, {ChainStage::separatrix}, files.graph, graph, field, files.nodes);
}

}  // namespace

stage::SeparatrixOptions layout_options(const ChainState& chain) {
  stage::SeparatrixOptions options = chain.values.separatrix;
  options.coarse_mesher = triangulate::coarse_triangles;
  return options;
}

bool make_graph(ChainState& chain, NodeFiles& files, const std::vector<std::string>& node_words) {
  if (!make_nodes(chain, files, node_words)) return false;
  StageFile<Field>* field = &chain.files.field;
  if (chain.options.is_dry_run && !have_phase_form(chain, files)) {
    print_phase_stages(chain, files);
  } else if (needs_own_field(chain, files)) {
    if (!solve_phase(chain, files)) return false;
    field = &files.phase;
    if (!is_before(chain.options.last, ChainStage::separatrix)) chain.last = files.nodes.path();
  }
  return trace(chain, files, *field);
}

namespace {

/// Words for critpoints, such as "--ties", "field".
using Remedy = std::vector<std::string>;

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
  for (const std::string& path : {files.nodes.path(), files.phase_solve.path(), files.phase.path(), files.graph.path()})
    std::filesystem::remove(path, ignored);
}

template <typename Model>
void replace(StageFile<Model>& file, StageFile<Model>& other) {
  std::error_code ignored;
  std::filesystem::remove(file.path(), ignored);
  std::filesystem::rename(other.path(), file.path(), ignored);
  file.take(other);
}

/// The runs of the remedy count, that of the graph which it replaces does not.
void take_remedy(ChainState& chain, NodeFiles& files, std::size_t replaced_run, std::size_t first_run) {
  std::vector<io::StageReport>& reports = chain.runner.reports();
  reports[replaced_run].stage = "failed_" + reports[replaced_run].stage;
  for (std::size_t i = first_run; i < reports.size(); ++i)
    reports[i].stage = "remedy_" + reports[i].stage.substr(std::string("failed_").size());
  NodeFiles& usual = chain.files.of_nodes;
  replace(usual.nodes, files.nodes);
  replace(usual.phase_solve, files.phase_solve);
  replace(usual.phase, files.phase);
  replace(usual.graph, files.graph);
  chain.last = usual.graph.path();
}

bool gives_layout(ChainState& chain, NodeFiles& files, const Remedy& remedy) {
  chain.prefix = "failed_";
  const bool is_made = make_graph(chain, files, remedy) &&
                       io::value_of(chain.runner.reports().back(), "certificate.method") != "midpoint";
  chain.prefix.clear();
  return is_made;
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
    inform(chain, fmt::format("no layout with these nodes: trying critpoints {} {}", remedy[0], remedy[1]));
    const std::size_t first_run = chain.runner.reports().size();
    NodeFiles files(chain.files.stem + ".remedy");
    if (gives_layout(chain, files, remedy)) {
      take_remedy(chain, files, replaced_run, first_run);
      print_warnings(chain, first_run);
      chain.remedy = fmt::format("critpoints {} {}", remedy[0], remedy[1]);
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

namespace {

bool solve_field(ChainState& chain) {
  ChainFiles& files = chain.files;
  const auto solve = [&](Run& run) {
    return stage::fieldsolve({files.triangles.input(), {}, {}, {}}, chain.values.fieldsolve, run);
  };
  const auto adapt = [&](Run& run) { return stage::padapt(files.solve.input(), chain.values.padapt, run); };
  const bool is_solved = make_file(chain, {ChainStage::fieldsolve}, files.solve, solve, files.triangles) &&
                         make_file(chain, {ChainStage::padapt}, files.field, adapt, files.solve);
  files.solve.forget();
  return is_solved;
}

bool divide_triangles(ChainState& chain) {
  StageFile<TriMesh>& triangles = chain.files.triangles;
  const auto graph = [&](Run& run) { return stage::separatrix(triangles.input(), layout_options(chain), run); };
  return make_file(chain, {ChainStage::separatrix}, chain.files.of_nodes.graph, graph, triangles);
}

bool make_blocks(ChainState& chain) {
  StageFile<SeparatrixGraph>& graph = chain.files.of_nodes.graph;
  const auto blocks = [&](Run& run) {
    const Names names = block_names(chain);
    return stage::blocksplit(graph.input(), names.input(), chain.values.blocksplit, run);
  };
  return make_file(chain, {ChainStage::blocksplit}, chain.files.blocks, blocks, graph);
}

bool refine_blocks(ChainState& chain) {
  StageFile<BlockLayout>& blocks = chain.files.blocks;
  const auto quads = [&](Run& run) {
    const stage::Input<BlockLayout> layout = blocks.input();
    const PrescribedSizes sizes = prescribed_sizes(chain, layout.model.face);
    return stage::quadrefine(layout, sizes.input(), chain.values.quadrefine, run);
  };
  return make_file(chain, {ChainStage::quadrefine}, chain.files.quads, quads, blocks);
}

bool quads_of_graph(ChainState& chain) { return make_blocks(chain) && refine_blocks(chain); }

bool quads_of_triangles(ChainState& chain) { return divide_triangles(chain) && quads_of_graph(chain); }

bool quads_of_field(ChainState& chain) {
  if (!solve_field(chain) || !make_graph(chain, chain.files.of_nodes, {})) return false;
  try_remedies(chain);
  return quads_of_graph(chain);
}

/// That the quads are made without a field.
void warn_of_triangles(const ChainState& chain) {
  if (chain.given_up->is_stopped) return print_stop(chain);
  inform(chain, fmt::format("{} found no valid result: the quads are made without a field",
                            *io::value_of(chain.given_up->report, "tool")));
}

}  // namespace

void make_quads(ChainState& chain) {
  using layout::LayoutChoice;
  const LayoutChoice choice = chain.values.separatrix.layout;
  if (choice == LayoutChoice::midpoint) {
    quads_of_triangles(chain);
    return;
  }
  chain.has_other_way = choice == LayoutChoice::automatic && !is_before(ChainStage::separatrix, chain.options.first) &&
                        !is_before(chain.options.last, ChainStage::separatrix);
  const bool is_made = quads_of_field(chain);
  chain.has_other_way = false;
  if (is_made) return;
  warn_of_triangles(chain);
  chain.prefix = "midpoint_";
  quads_of_triangles(chain);
  chain.prefix.clear();
}

}  // namespace quadrille::chain
