#pragma once
// The energy of a cross field as a function of the positions of its irregular nodes (lib/method.md §8.9).
//
// W is the renormalised energy: the limit of E = 1/2 int |grad phi|^2 outside small discs around the nodes, minus pi
// d_k^2 ln(1 / radius) for each node and omega_c beta_c^2 / 2 ln(1 / radius) for each corner with an angle term. On the
// unit disc with d_k = 1
//   W = -pi sum_{i != j} ln |a_i - a_j| - pi sum_{i, j} ln |1 - a_i conj(a_j)| + const.
// dW / da_k = -2 pi d_k (d_y phi_k, -d_x phi_k) at a_k, phi_k = phi - d_k arg(z - a_k), with hole winding fixed. W is
// the sum of a boundary integral and the energy of s. With the hole winding of least energy, W is continuous where the
// winding changes, but its gradient is not.
//
// A: the explicit part of phi = A + s (model/phase_nodes.hpp), L its harmonic conjugate: weight ln |z - q| for each
// weight arg (z - q), so theta_c contributes ln |z - c| - ln |z - p_c|. Integration by parts, with dn A = -dL / ds and
// dn L = dA / ds along the boundary, and g the boundary data of s, yields
//   W = 1/2 int |grad s|^2 + oint L dg + 1/2 oint L dA - pi sum_k d_k L_k(a_k) + sum_c (jump_c g + 1/2 jump_c A)
//   L_c(c),
// where L_k and L_c omit the term of node k and of apex c. dg = dPhi - dA and dPhi = 4 kappa ds on smooth pieces. At a
// corner with an angle term g is continuous and A jumps by -omega_c beta_c; at a slit g jumps, and A only where the
// slit's turns are centred. By
// the index sum, a unit of length smaller by the factor f adds (pi sum_k d_k^2 + 1/2 sum_c omega_c beta_c^2) ln f to W,
// as the radii of its discs demand, and nothing else. explicit_energy() computes all terms
// but the first.

#include <vector>

#include "field/phase_boundary.hpp"
#include "mesh/locate.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

/// The part of W that involves the explicit terms of a phase, including their coupling with s: Gauss quadrature on
/// pieces that are short relative to their distance from every q; error about 1e-11, with corner angles about 1e-8.
/// `terms` and `apex_turns`: as in PhaseBoundary for the prescribed nodes `asked`. Cost: number of terms times number
/// of pieces (some tens per curve).
double explicit_energy(const CadFace& face, const PhaseNodes& asked, const PhaseTerms& terms,
                       const std::vector<field::ApexTurn>& apex_turns);

/// dW / da_k; `remainder_slope`: the gradient of s at a_k.
Vec2 phase_energy_gradient(const PhaseTerms& terms, int k, Vec2 remainder_slope);

/// The location of a node in the mesh. Throws ComputeError if the node is not inside the mesh.
mesh::Location locate_node(const mesh::Locator& locator, const TriMesh& mesh, Vec2 node);

}  // namespace quadrille::galerkin
