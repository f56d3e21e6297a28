#include "refine/place_vertices.hpp"

#include <algorithm>
#include <utility>

#include "growth/block_shifts.hpp"
#include "refine/relax.hpp"

namespace quadrille::refine {
namespace {

constexpr int max_corrections = 3;

/// Keeps a mesh with other lines if it is better; returns whether it is.
bool keep_if_better(const SplitRequest& request, SplitMesh next, SplitMesh& result) {
  set_score(request, next);
  const bool is_better = mesh::is_better(next.score, result.score);
  if (is_better) result = std::move(next);
  return is_better;
}

void straighten_lines(const SplitRequest& request, SplitMesh& result) {
  SplitMesh next = result;
  std::vector<layers::RowShifts>& shifts = next.lines.shifts;
  shifts =
      growth::block_shifts(request.equal.blocks(), *result.walls, result.divisions, result.mesh, request.limits.growth);
  while (!std::ranges::all_of(shifts, &layers::RowShifts::empty)) {
    sample_mesh(request, &result.mesh, next);
    if (growth::drop_useless(result.mesh, next.mesh, shifts)) continue;
    keep_if_better(request, std::move(next), result);
    return;
  }
}

/// Returns whether this improves the mesh.
bool correct_lines(const SplitRequest& request, SplitMesh& result) {
  if (result.score.growth == 0) return false;
  SplitMesh next = result;
  growth::correct_factors(layout_of(request, result.settings), *result.walls, result.divisions, result.mesh,
                          request.limits.growth, next.lines);
  sample_mesh(request, &result.mesh, next);
  return keep_if_better(request, std::move(next), result);
}

/// By element: whether it lies in a block that has layers, which relaxation does not move.
std::vector<bool> elements_in_layered_blocks(const SplitMesh& split) {
  std::vector<bool> is_layered;
  if (split.walls)
    for (const int block : split.mesh.elem_block) is_layered.push_back(split.walls->has_wall(block));
  return is_layered;
}

}  // namespace

void place_vertices(const SplitRequest& request, SplitMesh& result) {
  if (result.growth) {
    straighten_lines(request, result);
    for (int i = 0; i < max_corrections && correct_lines(request, result); ++i) {
    }
  }
  if (request.options.relax == 0) return;
  relax_and_report(
      result.mesh,
      {request.options.relax, result.settings.tolerance, elements_in_layered_blocks(result), request.report.progress()},
      request.report);
  result.distance = mesh::boundary_distance(result.mesh);
  set_score(request, result);
}

}  // namespace quadrille::refine
