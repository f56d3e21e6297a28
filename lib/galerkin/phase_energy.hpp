#pragma once
// How the energy of a cross field changes with the places of its irregular nodes (phase-field.md point 9).
//
// W is what is left of E = 1/2 int |grad phi|^2 when small discs round the nodes are taken out and their own part,
// pi d_k^2 ln(1 / radius) each, is subtracted. On the unit disc with d_k = 1
//   W = -pi sum_{i != j} ln |a_i - a_j| - pi sum_{i, j} ln |1 - a_i conj(a_j)| + const.

#include <vector>

#include "base/vec2.hpp"
#include "galerkin/solve_phase.hpp"

namespace quadrille {

/// dW / da_k = -2 pi d_k (d_y phi_k, -d_x phi_k) at a_k, phi_k = phi - d_k arg(z - a_k), twists fixed; for each node.
/// Throws ComputeError where a node lies outside the mesh (between a curve and its elements).
std::vector<Vec2> phase_energy_gradient(const TriMesh& mesh, const PhaseSolution& solution);

}  // namespace quadrille
