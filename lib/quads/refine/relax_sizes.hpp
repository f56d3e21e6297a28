#pragma once
// Relaxation to the prescribed sizes, and shorter ones at bends of the boundary (sizing/curve_sizes): moves all
// vertices of a mesh but those that are fixed (refine/relax_problem), also those on sides of blocks and irregular ones,
// to the least size energy (refine/size_energy).
//
// The first matrix of the method (refine/size_relaxer) has the moves of all levels of the blocks' grids
// (refine/coarse_moves), so that the number of steps hardly grows with that of elements; where thin elements need more
// steps, it is that of the Hessian itself (refine/factored_hessian). Where sizes differ, they are those at the middles
// of elements, and are taken anew every few sweeps. Vertices on the boundary
// slide across smooth joints of curves without given names; then the nearest ones are put at these
// (refine/joint_vertices).

#include "base/report.hpp"
#include "refine/size_relaxer.hpp"

namespace quadrille::refine {

struct SizeRelaxed {
  QuadMesh mesh;   ///< measured (refine/validity), its edges inside shaped (refine/inner_edges)
  int sweeps = 0;  ///< steps that were made
  double energy_before = 0, energy_after = 0;  ///< means per element that may move
  double largest_move = 0;                     ///< of a vertex, a length
};

/// `mesh`: measured, its edges inside as the blocks are.
SizeRelaxed relax_to_sizes(const QuadMesh& mesh, const SizeRelaxation& options);

/// The keys relax.* of the report. `before`: the mesh that was relaxed.
void report_relaxation(Report& report, const QuadMesh& before, const SizeRelaxed& relaxed);

}  // namespace quadrille::refine
