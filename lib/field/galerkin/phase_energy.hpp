#pragma once
// The energy of a cross field as a function of the positions of its irregular nodes (lib/method.md §8.9).
//
// W is the renormalised energy: the limit of E = 1/2 int |grad phi|^2 outside small discs around the nodes, minus pi
// d_k^2 ln(1 / radius) for each node and omega_c beta_c^2 / 2 ln(1 / radius) for each corner with an angle term. On the
// unit disc with d_k = 1
//   W = -pi sum_{i != j} ln |a_i - a_j| - pi sum_{i, j} ln |1 - a_i conj(a_j)| + const.
// dW / da_k = -2 pi d_k (d_y phi_k, -d_x phi_k) at a_k, phi_k = phi - d_k arg(z - a_k), with hole winding fixed. W is
// the sum of a boundary integral (galerkin/explicit_energy.hpp) and the energy of s. With the hole winding of least
// energy, W is continuous where the winding changes, but its gradient is not.

#include <functional>
#include <memory>

#include "galerkin/solve_phase.hpp"

namespace quadrille::galerkin {

/// A function that evaluates W for any set of nodes on the mesh of `solver` with its order map. Its first call factors
/// the system, unless the solver has. It is not thread-safe. It throws as PhaseSolver::energy.
std::function<PhaseEnergy(const PhaseNodes&)> phase_energy_function(std::shared_ptr<PhaseSolver> solver,
                                                                    const PhaseOptions& options = {});

}  // namespace quadrille::galerkin
