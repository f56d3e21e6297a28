#include "chain/make_quads.hpp"

#include <fmt/format.h>

#include "chain/chain_inputs.hpp"
#include "chain/make_graph.hpp"
#include "chain/try_remedies.hpp"

namespace quadrille::chain {

namespace {

bool solve_field(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask solve;
  solve.stage = ChainStage::fieldsolve;
  solve.output = files.solve.path();
  solve.words = {files.triangles.path()};
  solve.compute = [&](Run& run) {
    files.solve.set(stage::fieldsolve({files.triangles.input(), {}, {}, {}}, chain.values.fieldsolve, run),
                    chain.keeps_files);
  };
  solve.write_inputs = [&] { files.triangles.write(); };
  solve.drop_result = [&] { files.solve.forget(); };
  StageTask adapt;
  adapt.stage = ChainStage::padapt;
  adapt.output = files.field.path();
  adapt.words = {files.solve.path()};
  adapt.compute = [&](Run& run) {
    files.field.set(stage::padapt(files.solve.input(), chain.values.padapt, run), chain.keeps_files);
  };
  adapt.write_inputs = [&] { files.solve.write(); };
  adapt.drop_result = [&] { files.field.forget(); };
  const bool is_solved = run_stage(chain, solve) && run_stage(chain, adapt);
  files.solve.forget();
  return is_solved;
}

bool divide_triangles(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask task;
  task.stage = ChainStage::separatrix;
  task.output = files.of_nodes.graph.path();
  task.words = {files.triangles.path()};
  task.compute = [&](Run& run) {
    files.of_nodes.graph.set(stage::separatrix(files.triangles.input(), layout_options(chain), run), chain.keeps_files);
  };
  task.write_inputs = [&] { files.triangles.write(); };
  task.drop_result = [&] { files.of_nodes.graph.forget(); };
  return run_stage(chain, task);
}

bool refine_blocks(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask task;
  task.stage = ChainStage::quadrefine;
  task.output = files.quads.path();
  task.words = {files.of_nodes.blocks.path()};
  task.compute = [&](Run& run) {
    const stage::Input<BlockLayout> layout = files.of_nodes.blocks.input();
    const PrescribedSizes sizes = prescribed_sizes(chain, layout.model.face);
    files.quads.set(stage::quadrefine(layout, sizes.input(), chain.values.quadrefine, run), chain.keeps_files);
  };
  task.write_inputs = [&] { files.of_nodes.blocks.write(); };
  task.drop_result = [&] { files.quads.forget(); };
  return run_stage(chain, task);
}

bool quads_of_triangles(ChainState& chain) {
  return divide_triangles(chain) && make_blocks(chain, chain.files.of_nodes) && refine_blocks(chain);
}

bool quads_of_field(ChainState& chain) {
  if (!solve_field(chain) || !make_graph(chain, chain.files.of_nodes, {})) return false;
  try_remedies(chain);
  if (!make_blocks(chain, chain.files.of_nodes)) return false;
  try_better_nodes(chain);
  return refine_blocks(chain);
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
