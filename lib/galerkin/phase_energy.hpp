#pragma once
// How the energy of a cross field depends on the places of its irregular nodes (lib/method.md §8.9).
//
// W is what is left of E = 1/2 int |grad phi|^2 when small discs round the nodes are taken out and their own part,
// pi d_k^2 ln(1 / radius) each, is subtracted; likewise at corners with an angle term, omega_c beta_c^2 / 2 ln(1 /
// radius) each. On the unit disc with d_k = 1
//   W = -pi sum_{i != j} ln |a_i - a_j| - pi sum_{i, j} ln |1 - a_i conj(a_j)| + const.
// dW / da_k = -2 pi d_k (d_y phi_k, -d_x phi_k) at a_k, phi_k = phi - d_k arg(z - a_k), twists fixed. W itself is a
// boundary integral (galerkin/explicit_energy.hpp) and the energy of s. Twists at their best: W is continuous where
// they change, its gradient is not.

#include <functional>
#include <vector>

#include "galerkin/solve_phase.hpp"
#include "mesh/locate.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

/// W for many sets of nodes on the mesh of `field`, of any kind, with its orders. Keeps a copy of the mesh; the first
/// call factors. Not for several threads at once. Throws as PhaseSolver::energy.
std::function<PhaseEnergy(const PhaseNodes&)> phase_energy_function(const Field& field,
                                                                    const PhaseOptions& options = {},
                                                                    int num_threads = 1);

/// dW / da_k from the gradient of s at a_k.
Vec2 phase_energy_gradient(const PhaseTerms& terms, int k, Vec2 remainder_slope);

/// Gradient of s in the plane, coefficients in the orthogonal basis.
Vec2 remainder_gradient(const spectral::TriMap& map, Vec2 xi, int order, const double* coefs);

/// Throws ComputeError where the node is not inside the mesh.
mesh::Location locate_node(const mesh::Locator& locator, const TriMesh& mesh, Vec2 node);

}  // namespace quadrille::galerkin
