#pragma once
// Checks whether the irregular nodes and corner valences of a file are feasible on a face.

#include <string>

#include "galerkin/solve_phase.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::galerkin {

/// Gives the nodes to the solver of a mesh of this face (PhaseSolver::set_nodes). Throws FormatError, whose message
/// starts with the file name `name` and states the error and its position, for
/// - a corner or boundary node whose blocks would have angles omega / V outside [15, 165] degrees (V = 0 is a
/// degenerate corner and allowed: it is handled later by midpoint division);
/// - valences whose index sum is not 4 chi, with the sums;
/// - nodes that are not inside the face, corners and curves that do not exist or are listed twice (PhaseBoundary).
void require_possible(PhaseSolver& solver, const CadFace& face, const PhaseNodes& asked, const std::string& name);

}  // namespace quadrille::galerkin
