#pragma once
// The energy of the boundary modes of an element by harmonic polynomials, in place of interior modes.
//
// The function of least energy for given values on the boundary is harmonic. So the energy is computed from the
// harmonic polynomials of degree up to P + 6 (harmonic_frame.hpp), by integrals along the edges alone: with the energy
// projection Pi onto them,
//     S = a(Pi ., Pi .) + R^T D R,   R = I - T Pi less the mean value of the vertices,
// T the traces of the polynomials in the boundary modes, and D the energies of these modes on an equilateral triangle,
// which makes the energy of what the polynomials do not represent positive. This is the harmonic virtual element method
// (Chernov and Mascotto 2019); about P^3 operations in place of P^6 / 24.

#include <Eigen/Dense>
#include <optional>

#include "spectral/tri_map.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {

/// `schur`: S; `projection`: Pi, a column per boundary mode, coefficients of Re p_1, Im p_1, Re p_2, ... Nothing below
/// order 3, where there is at most one interior mode, and if the element is slender, strongly curved or folded.
std::optional<CondensedElement> harmonic_element(const spectral::TriMap& map, int order);

/// The solution inside. Coefficients in the orthogonal basis of order P, one function a column: the projection of the
/// harmonic polynomial `projection` * `boundary` onto the polynomials of the reference triangle, plus the function of
/// least energy on an equilateral triangle that corrects its boundary modes to the given ones.
Eigen::MatrixXd harmonic_coefs(const spectral::TriMap& map, int order, const Eigen::MatrixXd& projection,
                               const Eigen::MatrixXd& boundary);

}  // namespace quadrille::stiffness
