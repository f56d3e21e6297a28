#include "chain/make_quads.hpp"

#include <fmt/format.h>

#include "chain/choose_nodes.hpp"
#include "chain/quad_inputs.hpp"
#include "chain/try_remedies.hpp"
#include "triangulate/coarse_triangles.hpp"

namespace quadrille::chain {

namespace {

bool solve_field(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask solve;
  solve.stage = Stage::fieldsolve;
  solve.output = files.solve.path();
  solve.words = {files.triangles.path()};
  solve.compute = [&](Run& run) {
    files.solve.set(stage::fieldsolve({files.triangles.input(), {}, {}, {}}, chain.values.fieldsolve, run),
                    chain.keeps_files);
  };
  solve.write_inputs = [&] { files.triangles.write(); };
  solve.drop_result = [&] { files.solve.forget(); };
  StageTask adapt;
  adapt.stage = Stage::padapt;
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

/// The field that has prescribed nodes.
bool solve_phase(ChainState& chain, NodeFiles& files) {
  StageFile<TriMesh>& triangles = chain.files.triangles;
  StageFile<Field>& field = chain.files.field;
  StageTask solve;
  solve.stage = Stage::fieldsolve;
  solve.is_of_phase = true;
  solve.output = files.phase_solve.path();
  solve.words = {"--nodes", files.nodes.name(), "--orders", field.path(), triangles.path()};
  solve.compute = [&](Run& run) {
    const OrderMap orders{field.model().elem_order, field.model().kind == FieldKind::harmonic};
    stage::FieldsolveInput input{triangles.input(), {}, "field", {}};
    input.orders.emplace(orders, field.input().file);
    input.nodes.emplace(files.nodes.input());
    files.phase_solve.set(stage::fieldsolve(input, chain.values.fieldsolve, run), chain.keeps_files);
  };
  solve.write_inputs = [&] { triangles.write(), field.write(), files.nodes.write(); };
  solve.drop_result = [&] { files.phase_solve.forget(); };
  StageTask adapt;
  adapt.stage = Stage::padapt;
  adapt.is_of_phase = true;
  adapt.output = files.phase.path();
  adapt.words = {files.phase_solve.path()};
  adapt.compute = [&](Run& run) {
    files.phase.set(stage::padapt(files.phase_solve.input(), chain.values.padapt, run), chain.keeps_files);
  };
  adapt.write_inputs = [&] { files.phase_solve.write(); };
  adapt.drop_result = [&] { files.phase.forget(); };
  const bool is_solved = run_stage(chain, solve) && run_stage(chain, adapt);
  files.phase_solve.forget();
  return is_solved;
}

/// With --dry-run, for a person: whether they run depends on what critpoints finds.
void print_phase_stages(ChainState& chain, NodeFiles& files) {
  if (!chain.is_due(Stage::separatrix)) return;
  fmt::print("# if \"form\" is \"phase\" in {}, or its nodes were edited; separatrix then reads {}:\n",
             files.nodes.name(), files.phase.path());
  const std::string before = chain.last;
  chain.comment = "# ";
  solve_phase(chain, files);
  chain.comment.clear();
  chain.last = before;
}

/// The layout options with what makes midpoint division possible.
stage::SeparatrixOptions layout_options(const ChainState& chain) {
  stage::SeparatrixOptions options = chain.values.separatrix;
  options.coarse_mesher = triangulate::coarse_triangles;
  return options;
}

bool trace(ChainState& chain, NodeFiles& files, StageFile<Field>& field) {
  StageTask task;
  task.stage = Stage::separatrix;
  task.output = files.graph.path();
  task.words = {field.path(), files.nodes.name()};
  task.compute = [&](Run& run) {
    files.graph.set(stage::separatrix(field.input(), files.nodes.input(), layout_options(chain), run),
                    chain.keeps_files);
  };
  task.write_inputs = [&] { field.write(), files.nodes.write(); };
  task.drop_result = [&] { files.graph.forget(); };
  return run_stage(chain, task);
}

bool divide_triangles(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask task;
  task.stage = Stage::separatrix;
  task.output = files.of_nodes.graph.path();
  task.words = {files.triangles.path()};
  task.compute = [&](Run& run) {
    files.of_nodes.graph.set(stage::separatrix(files.triangles.input(), layout_options(chain), run), chain.keeps_files);
  };
  task.write_inputs = [&] { files.triangles.write(); };
  task.drop_result = [&] { files.of_nodes.graph.forget(); };
  return run_stage(chain, task);
}

bool make_blocks(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask task;
  task.stage = Stage::blocksplit;
  task.output = files.blocks.path();
  task.words = {files.of_nodes.graph.path()};
  task.compute = [&](Run& run) {
    const Names names = block_names(chain);
    files.blocks.set(stage::blocksplit(files.of_nodes.graph.input(), names.input(), chain.values.blocksplit, run),
                     chain.keeps_files);
  };
  task.write_inputs = [&] { files.of_nodes.graph.write(); };
  task.drop_result = [&] { files.blocks.forget(); };
  return run_stage(chain, task);
}

bool refine_blocks(ChainState& chain) {
  ChainFiles& files = chain.files;
  StageTask task;
  task.stage = Stage::quadrefine;
  task.output = files.quads.path();
  task.words = {files.blocks.path()};
  task.compute = [&](Run& run) {
    const stage::Input<BlockLayout> layout = files.blocks.input();
    const PrescribedSizes sizes = prescribed_sizes(chain, layout.model.face);
    files.quads.set(stage::quadrefine(layout, sizes.input(), chain.values.quadrefine, run), chain.keeps_files);
  };
  task.write_inputs = [&] { files.blocks.write(); };
  task.drop_result = [&] { files.quads.forget(); };
  return run_stage(chain, task);
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

bool make_graph(ChainState& chain, NodeFiles& files, const std::vector<std::string>& node_words) {
  if (!make_nodes(chain, files, node_words)) return false;
  StageFile<Field>* field = &chain.files.field;
  if (chain.options.is_dry_run && !have_phase_form(chain, files)) {
    print_phase_stages(chain, files);
  } else if (needs_own_field(chain, files)) {
    if (!solve_phase(chain, files)) return false;
    field = &files.phase;
    if (!is_before(chain.options.last, Stage::separatrix)) chain.last = files.nodes.path();
  }
  return trace(chain, files, *field);
}

void make_quads(ChainState& chain) {
  using layout::LayoutChoice;
  const LayoutChoice choice = chain.values.separatrix.layout;
  if (choice == LayoutChoice::midpoint) {
    quads_of_triangles(chain);
    return;
  }
  chain.has_other_way = choice == LayoutChoice::automatic && !is_before(Stage::separatrix, chain.options.first) &&
                        !is_before(chain.options.last, Stage::separatrix);
  const bool is_made = quads_of_field(chain);
  chain.has_other_way = false;
  if (is_made) return;
  warn_of_triangles(chain);
  chain.prefix = "midpoint_";
  quads_of_triangles(chain);
  chain.prefix.clear();
}

}  // namespace quadrille::chain
