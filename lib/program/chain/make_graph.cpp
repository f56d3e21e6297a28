#include "chain/make_graph.hpp"

#include <fmt/format.h>

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
  StageTask solve;
  solve.stage = ChainStage::fieldsolve;
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
  adapt.stage = ChainStage::padapt;
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
  StageTask task;
  task.stage = ChainStage::separatrix;
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

}  // namespace

stage::SeparatrixOptions layout_options(const ChainState& chain) {
  stage::SeparatrixOptions options = chain.values.separatrix;
  options.coarse_mesher = triangulate::coarse_triangles;
  return options;
}

bool make_graph(ChainState& chain, NodeFiles& files, const std::vector<std::string>& node_words) {
  return make_nodes(chain, files, node_words) && make_graph(chain, files);
}

bool make_graph(ChainState& chain, NodeFiles& files) {
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

bool make_blocks(ChainState& chain, NodeFiles& files) {
  StageTask task;
  task.stage = ChainStage::blocksplit;
  task.output = files.blocks.path();
  task.words = {files.graph.path()};
  task.compute = [&](Run& run) {
    const Names names = block_names(chain);
    files.blocks.set(stage::blocksplit(files.graph.input(), names.input(), chain.values.blocksplit, run),
                     chain.keeps_files);
  };
  task.write_inputs = [&] { files.graph.write(); };
  task.drop_result = [&] { files.blocks.forget(); };
  return run_stage(chain, task);
}

}  // namespace quadrille::chain
