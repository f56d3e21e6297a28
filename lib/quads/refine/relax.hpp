#pragma once
// Relaxation: moves the vertices of a valid mesh so that elements have better shapes; all other nodes follow.
//
// A sweep is a step of preconditioned conjugate gradients for the shape energy (refine/relax_problem) in all vertices
// at once, so that symmetric meshes stay symmetric, independent of their numbering: inner vertices move freely, also on
// sides of blocks, those on the boundary slide along it (refine/relax_problem). Nodes on inner edges follow the ends
// linearly, those on the boundary are placed on the curves again, inner ones are shifted by the transfinite blend of
// their element's sides. A vertex moves back if an element would have a smaller scaled Jacobian than the worst of the
// mesh has, or not be proved valid, or if the boundary would miss its tolerance: the least scaled Jacobian never falls.

#include "base/progress.hpp"
#include "base/report.hpp"
#include "refine/relax_problem.hpp"

namespace quadrille::refine {

/// A measured mesh and the moves of its vertices that led to it.
struct RelaxState {
  QuadMesh mesh;
  VertexMoves moves;
  double energy = 0;  ///< RelaxProblem::total_energy
};

/// Measures those elements of `trial` that have moved since `state`, and resets the moves of all vertices at elements
/// and boundary edges that break a limit to their moves in `state`. Values that are equal within 1e-6 break a limit
/// together, so that mirror images are treated equally. False, with `trial` fully measured, if no vertex had to be
/// reset. `tolerance`: greatest distance between boundary and curves.
bool reset_forbidden_moves(const RelaxProblem& problem, const RelaxState& state, double tolerance, RelaxState& trial);

/// The direction in which relaxation moves all vertices at once: preconditioned conjugate gradients (Polak-Ribiere,
/// with a restart if the direction does not descend) for the shape energy. The preconditioner is the inverse of the
/// Hessian's diagonal blocks, one for each vertex. On the boundary gradient and block are reduced to the curve's
/// tangent. No vertex moves by more than a quarter of the shortest edge at it.
class ConjugateDescent {
 public:
  /// `problem` must outlive it.
  explicit ConjugateDescent(const RelaxProblem& problem) : problem_(&problem) {}

  /// The direction at these nodes, which result from `moves`, conjugate to the one before. 0 for fixed vertices.
  VertexMoves next(const std::vector<Vec2>& nodes, const VertexMoves& moves);

 private:
  const RelaxProblem* problem_;
  VertexMoves last_gradient_, last_direction_;
  double last_slope_ = 0;  ///< of the energy along the descent of the last call; < 0 after the first
};

struct RelaxOptions {
  int sweeps = 0;                       ///< greatest number; fewer if no vertex moves any more
  double tolerance = 0;                 ///< greatest distance between mesh boundary and CAD curve, a length, > 0
  std::vector<bool> frozen_elems = {};  ///< elements that keep all nodes; empty: none
  Progress* progress = nullptr;
};

struct RelaxOutcome {
  int sweeps = 0;                              ///< number of sweeps that moved a vertex
  double energy_before = 0, energy_after = 0;  ///< means per element
  double largest_move = 0;                     ///< of a vertex, a length
};

/// `mesh` must be measured (refine/validity) and is so again afterwards. A mesh that is not valid is not changed.
RelaxOutcome relax(QuadMesh& mesh, const RelaxOptions& options);

/// The same, with the keys relax.* of the report.
void relax_and_report(QuadMesh& mesh, const RelaxOptions& options, Report& report);

}  // namespace quadrille::refine
