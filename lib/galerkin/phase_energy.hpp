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

#include "galerkin/solve_phase.hpp"

namespace quadrille::galerkin {

/// W for many sets of nodes on the mesh of `field`, of any kind, with its orders. Keeps a copy of the mesh; the first
/// call factors. Not for several threads at once. Throws as PhaseSolver::energy.
std::function<PhaseEnergy(const PhaseNodes&)> phase_energy_function(const Field& field,
                                                                    const PhaseOptions& options = {},
                                                                    int num_threads = 1);

}  // namespace quadrille::galerkin
