#pragma once
// The limits of every step of the relaxation: no element becomes worse than the worst of the mesh, all stay proved
// valid, and the boundary stays within its tolerance.

#include "model/quad_mesh.hpp"
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

}  // namespace quadrille::refine
