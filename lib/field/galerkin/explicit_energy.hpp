#pragma once
// The part of the energy W (galerkin/phase_energy.hpp) that involves the explicit terms of a phase, including their
// coupling with s.
//
// A: the explicit part of phi = A + s (model/phase_nodes.hpp), L its harmonic conjugate: weight ln |z - q| for each
// weight arg (z - q), so theta_c contributes ln |z - c| - ln |z - p_c|. Integration by parts, with dn A = -dL / ds and
// dn L = dA / ds along the boundary, and g the boundary data of s, yields
//   W = 1/2 int |grad s|^2 + oint L dg + 1/2 oint L dA - pi sum_k d_k L_k(a_k) - 1/2 sum_c omega_c beta_c L_c(c),
// where L_k and L_c omit the term of node k and of apex c. dg = dPhi - dA and dPhi = 4 kappa ds on smooth pieces. By
// the index sum, a unit of length smaller by the factor f adds (pi sum_k d_k^2 + 1/2 sum_c omega_c beta_c^2) ln f to W,
// as the radii of its discs demand, and nothing else. This header computes all terms but the first.

#include <vector>

#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::galerkin {

/// Gauss quadrature on pieces that are short relative to their distance from every q; error about 1e-11, with corner
/// angles about 1e-8. `terms`: as in PhaseBoundary for the prescribed nodes `asked`; `interior_angles`: omega_c,
/// radians, of each corner angle. Cost: number of terms times number of pieces (some tens per curve).
double explicit_energy(const CadFace& face, const PhaseNodes& asked, const PhaseTerms& terms,
                       const std::vector<double>& interior_angles);

}  // namespace quadrille::galerkin
