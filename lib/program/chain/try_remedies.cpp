#include "chain/try_remedies.hpp"

#include <fmt/format.h>

#include <filesystem>
#include <tuple>

#include "chain/make_graph.hpp"

namespace quadrille::chain {

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

}  // namespace quadrille::chain
