#include "chain/make_quads.hpp"

#include <fmt/format.h>

#include "chain/chain_inputs.hpp"
#include "chain/chain_nodes.hpp"
#include "chain/make_graph.hpp"
#include "chain/try_remedies.hpp"

namespace quadrille::chain {

namespace {

bool solve_field(ChainState& chain) {
  ChainFiles& files = chain.files;
  const auto solve = [&](Run& run) {
    const auto directions = directions_to_align_with(chain);
    return stage::fieldsolve({files.triangles.input(), {}, {}, {}, directions.input()}, chain.values.fieldsolve, run);
  };
  const auto adapt = [&](Run& run) { return stage::padapt(files.solve.input(), chain.values.padapt, run); };
  const bool is_solved = make_file(chain, {ChainStage::fieldsolve}, files.solve, solve, files.triangles) &&
                         make_file(chain, {ChainStage::padapt}, files.field, adapt, files.solve);
  files.solve.forget();
  return is_solved;
}

bool divide_triangles(ChainState& chain) {
  ChainFiles& files = chain.files;
  const auto graph = [&](Run& run) { return stage::separatrix(files.triangles.input(), layout_options(chain), run); };
  return make_file(chain, {ChainStage::separatrix}, files.of_nodes.graph, graph, files.triangles);
}

bool refine_blocks(ChainState& chain) {
  StageFile<BlockLayout>& blocks = chain.files.of_nodes.blocks;
  const auto quads = [&](Run& run) {
    const auto sizes = prescribed_sizes(chain);
    const auto metric = prescribed_metric(chain);
    const auto directions = directions_to_align_with(chain);
    return stage::quadrefine({blocks.input(), sizes.input(), metric.input(), directions.input()},
                             chain.values.quadrefine, run);
  };
  return make_file(chain, {ChainStage::quadrefine}, chain.files.of_nodes.quads, quads, blocks);
}

bool quads_of_triangles(ChainState& chain) {
  return divide_triangles(chain) && make_blocks(chain, chain.files.of_nodes) && refine_blocks(chain);
}

bool quads_of_field(ChainState& chain) {
  NodeFiles& files = chain.files.of_nodes;
  if (!solve_field(chain) || !make_nodes(chain, files, {}) || !make_graph(chain, files)) return false;
  try_remedies(chain);
  return make_blocks(chain, files) && (try_better_nodes(chain) || refine_blocks(chain));
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
