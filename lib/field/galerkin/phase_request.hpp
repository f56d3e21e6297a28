#pragma once
// What the phase form is solved for: nodes and corner valences that are feasible on a face, and orders.

#include <string>
#include <vector>

#include "galerkin/solve_phase.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

/// Gives the nodes to the solver of a mesh of this face (PhaseSolver::set_nodes). Throws FormatError, whose message
/// starts with the file name `name` and states the error and its position, for
/// - a corner or boundary node whose blocks would have angles omega / V outside [15, 165] degrees (V = 0 is a
/// degenerate corner and allowed: it is handled later by midpoint division);
/// - valences whose index sum is not 4 chi, with the sums;
/// - nodes that are not inside the face, corners and curves that do not exist or are listed twice (PhaseBoundary).
void require_possible(PhaseSolver& solver, const CadFace& face, const PhaseNodes& asked, const std::string& name);

/// An order for each element at which s (lib/method.md §8.3) is resolved as v is with the orders `field_orders` of the
/// harmonic field.
///
/// s is smoother than v, which turns four times as far as the cross and has no explicit terms: on the 30 shapes of the
/// tests and on plates with 1,000 holes it needs at most half of the order of v and 5 more. Along straight boundaries,
/// where the data of v are constant but not those of s, and in corner fans, where both have the same singularity, it
/// may need as much as v. No order exceeds that of v.
std::vector<int> phase_orders(const TriMesh& mesh, const std::vector<int>& field_orders);

}  // namespace quadrille::galerkin
