#pragma once
// The complex coordinate z of an element, and a well conditioned basis of its harmonic polynomials: Re p_k(z) and
// Im p_k(z), k >= 1, with
//     p_{k+1} = z p_k - b p_{k-1} - p_{k-2} / 3,   p_0 = 1, p_{-1} = p_{-2} = 0.
// These are nearly the Faber polynomials of the triangle: for an equilateral one (b = 0), its outside is the image of
// the outside of a circle under w + 1 / (3 w^2) + ...; for an ellipse it is that under w + b / w. Powers of z would be
// so nearly dependent at degree 26 that five digits were lost.

#include <Eigen/Dense>
#include <complex>

#include "base/vec2.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::stiffness {

/// The degree of the harmonic polynomials on an element of order P. What the polynomials of degree P cannot represent
/// reaches the energies of the boundary modes: with P + 6 the field is as accurate as with all polynomials of degree P,
/// with P it has ten times the error.
constexpr int harmonic_degree(int order) { return order + 6; }

struct HarmonicFrame {
  Vec2 centre;                 ///< of the vertices
  std::complex<double> scale;  ///< z = scale * (x - centre)
  std::complex<double> b;      ///< |b| < 1: 0 if the vertices form an equilateral triangle

  explicit HarmonicFrame(const spectral::TriMap& map);
  std::complex<double> operator()(Vec2 x) const { return scale * std::complex(x.x - centre.x, x.y - centre.y); }
  /// The ratio of the singular values, at least 1, of the affine map of the equilateral triangle onto the vertices:
  /// energies on both differ at most by this factor.
  double slenderness() const { return (1 + std::abs(b)) / (1 - std::abs(b)); }
};

/// The next polynomial of the recurrence, for numbers or arrays. `p`, `p1`, `p2`: p_k, p_{k-1}, p_{k-2}.
template <class Z, class P>
auto next_polynomial(const Z& z, std::complex<double> b, const P& p, const P& p1, const P& p2) {
  return z * p - b * p1 - p2 / 3.0;
}

/// The equilateral triangle, which stands for elements of any shape where only the size of an energy matters.
struct Equilateral {
  Eigen::VectorXd root_diagonal;  ///< the roots of the diagonal of its Schur complement: roots of the modes' energies
  Eigen::MatrixXd extension;      ///< column: orthogonal coefficients of the least energy for a boundary mode
};

/// Of order >= 1; computed once.
const Equilateral& equilateral(int order);

}  // namespace quadrille::stiffness
