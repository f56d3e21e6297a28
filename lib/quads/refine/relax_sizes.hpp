#pragma once
// Relaxation to the prescribed sizes, and shorter ones at bends of the boundary (sizing/curve_sizes): moves all
// vertices of a mesh but those that are fixed (refine/relax_problem), also those on sides of blocks and irregular ones,
// to the least size energy (refine/size_energy).
//
// The first matrix of the method (refine/size_relaxer) has the moves of all levels of the blocks' grids
// (refine/coarse_moves), so that the number of steps hardly grows with that of elements; where thin elements need more
// steps, it is that of the Hessian itself (refine/factored_hessian). Where sizes differ, they are those at the middles
// of elements, taken anew with their gradients every few sweeps. Vertices on the boundary slide across smooth joints of
// curves without given names; then the nearest ones are put at these (refine/joint_vertices). Those on curves of equal
// elements are first put at equal lengths (refine/even_vertices).

#include <limits>
#include <memory>

#include "base/report.hpp"
#include "refine/size_relaxer.hpp"

namespace quadrille::refine {

class VertexRelaxation;

struct SizeRelaxed {
  QuadMesh mesh;   ///< measured (refine/validity), its edges inside shaped (refine/inner_edges)
  int sweeps = 0;  ///< steps that were made
  double energy_before = 0, energy_after = 0;         ///< means per element that may move
  double largest_move = 0;                            ///< of a vertex, a length
  std::shared_ptr<VertexRelaxation> relaxation = {};  ///< by which it may be relaxed further
};

/// Vertices on their way to the least energy.
class VertexRelaxation {
 public:
  /// `mesh`: measured, its edges inside as the blocks are; `shaped`: with these shaped.
  VertexRelaxation(const QuadMesh& mesh, const QuadMesh& shaped, const SizeRelaxation& options, SlidesOff slides_off);
  VertexRelaxation(const VertexRelaxation&) = delete;
  VertexRelaxation& operator=(const VertexRelaxation&) = delete;

  /// Relaxes until sweeps lower the energy by less than a part of it. Returns false if edges or elements cannot be as
  /// they must: with joints that vertices slide off, it may be impossible to have vertices at all of them again, or
  /// take more than four times the energy. `result` is kept then, and where the work was too much.
  bool run(double least_progress, SizeRelaxed& result);
  /// Lowers the tolerance of the boundary for the next runs.
  void tighten(double factor) { options_.tolerance *= factor; }
  /// Of the last run.
  double least_progress() const { return relaxer_.least_progress; }
  /// Whether vertices may slide off smooth joints.
  bool passes_joints() const { return passes_joints_; }
  /// The mesh before.
  const QuadMesh& before() const { return problem_.start; }

 private:
  bool begin();

  SizeRelaxation options_;
  const QuadMesh shaped_;
  RelaxProblem problem_;
  SizeRelaxer relaxer_;
  const bool passes_joints_;
  const double energy_before_;
  double most_value_ = std::numeric_limits<double>::infinity();  ///< of the energy: with more, joints are not met
  bool is_begun_ = false;
};

/// `mesh`: measured, its edges inside as the blocks are.
SizeRelaxed relax_to_sizes(const QuadMesh& mesh, const SizeRelaxation& options);

/// The keys relax.* of the report. `before`: the mesh that was relaxed.
void report_relaxation(Report& report, const QuadMesh& before, const SizeRelaxed& relaxed);

}  // namespace quadrille::refine
