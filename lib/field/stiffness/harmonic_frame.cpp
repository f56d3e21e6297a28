#include "stiffness/harmonic_frame.hpp"

#include <array>
#include <cmath>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/per_order.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {
namespace {

Equilateral make_equilateral(int order) {
  const spectral::TriMap map(std::array{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.5, std::sqrt(0.75)}});
  const CondensedElement element = condense(order, stiffness_matrix(map, order));
  const int nb = spectral::num_boundary_modes(order);
  Eigen::MatrixXd modes(spectral::num_tri_modes(order), nb);
  modes << Eigen::MatrixXd::Identity(nb, nb), *element.interior;
  return {element.schur.dense().diagonal().cwiseSqrt(), spectral::modified_to_orthogonal(order).transpose() * modes};
}

}  // namespace

// The affine map of the equilateral triangle 1, e^(2 pi i / 3), e^(-2 pi i / 3) is w -> alpha w + beta conj(w). The
// outside of that triangle is the image of |w| > capacity.
HarmonicFrame::HarmonicFrame(const spectral::TriMap& map) {
  constexpr double capacity = 0.7303;
  const std::array vertices{map.position({-1, -1}), map.position({1, -1}), map.position({-1, 1})};
  centre = (vertices[0] + vertices[1] + vertices[2]) / 3;
  std::complex<double> alpha = 0, beta = 0;
  const std::array<std::complex<double>, 3> roots{{{1, 0}, {-0.5, std::sqrt(0.75)}, {-0.5, -std::sqrt(0.75)}}};
  for (int k = 0; k < 3; ++k) {
    const std::complex z(vertices[k].x - centre.x, vertices[k].y - centre.y);
    alpha += z * std::conj(roots[k]) / 3.0;
    beta += z * roots[k] / 3.0;
  }
  scale = 1.0 / (capacity * alpha);
  b = beta / alpha;
}

const Equilateral& equilateral(int order) {
  static spectral::PerOrder<Equilateral> tables(make_equilateral);
  return tables[order];
}

}  // namespace quadrille::stiffness
