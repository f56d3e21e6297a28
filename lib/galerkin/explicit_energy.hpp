#pragma once
// The part of the energy W (galerkin/phase_energy.hpp) that the explicit terms of a phase have, alone and with s.
//
// A: the explicit part of phi = A + s (model/phase_terms.hpp), L its conjugate: weights ln |z - q| for arg (z - q), so
// theta_c has c and -p_c. By parts, with dn A = -dL / ds and dn L = dA / ds along the boundary, and g the data of s,
//   W = 1/2 int |grad s|^2 + oint L dg + 1/2 oint L dA - pi sum_k d_k L_k(a_k) - 1/2 sum_c omega_c beta_c L_c(c),
// L_k, L_c without the own term of node k, of apex c. dg = dPhi - dA and dPhi = 4 kappa ds on smooth pieces. A factor
// in L (the unit of length) drops out by the index sum. All but the first term:

#include <vector>

#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/phase_terms.hpp"

namespace quadrille::galerkin {

/// By Gauss' rule on pieces that are short beside their distance from every q, to about 1e-11. `terms` are those of
/// PhaseBoundary for `asked`, with omega_c of each of its corner angles. Cost: terms times pieces, some tens a curve.
double explicit_energy(const CadFace& face, const PhaseNodes& asked, const PhaseTerms& terms,
                       const std::vector<double>& interior_angles);

}  // namespace quadrille::galerkin
