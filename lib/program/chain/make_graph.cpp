#include "chain/make_graph.hpp"

#include <fmt/format.h>

#include <utility>

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
    const auto directions = directions_to_align_with(chain);
    stage::FieldsolveInput input{triangles.input(), {}, "field", {}, directions.input()};
    input.orders.emplace(orders, field.input().file);
    input.nodes.emplace(files.nodes.input());
    return stage::fieldsolve(input, chain.values.fieldsolve, run);
  };
  const auto adapt = [&](Run& run) { return stage::padapt(files.phase_solve.input(), chain.values.padapt, run); };
  StageTask task{ChainStage::fieldsolve, true, {"--nodes", files.nodes.name(), "--orders", field.path()}};
  task.words.push_back(triangles.path());
  const bool is_solved = make_file(chain, std::move(task), files.phase_solve, solve, triangles, field, files.nodes) &&
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
  const auto blocks = [&](Run& run) {
    const auto names = block_names(chain);
    return stage::blocksplit(files.graph.input(), names.input(), chain.values.blocksplit, run);
  };
  return make_file(chain, {ChainStage::blocksplit}, files.blocks, blocks, files.graph);
}

}  // namespace quadrille::chain
