#include "stiffness/condensed_element.hpp"

#include <cmath>
#include <complex>
#include <cstdint>
#include <map>
#include <utility>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "stiffness/element_matrices.hpp"
#include "stiffness/harmonic_element.hpp"

namespace quadrille::stiffness {
namespace {

constexpr double same = 1e-12;

// The coefficients of x + iy but the constant one, divided by that of mode 2, the direction of edge 0, as multiples of
// `same`: what a similarity transform leaves as it is.
std::vector<std::int64_t> shape_of(const spectral::TriMap& map) {
  const auto coef = [&](std::size_t i) { return std::complex(map.coefs_x()[i], map.coefs_y()[i]); };
  const std::complex<double> scale = same * coef(2);
  std::vector<std::int64_t> shape;
  for (std::size_t i = 1; i < map.coefs_x().size(); ++i) {
    const std::complex<double> ratio = coef(i) / scale;
    shape.push_back(std::llround(ratio.real()));
    shape.push_back(std::llround(ratio.imag()));
  }
  return shape;
}

}  // namespace

CondensedElement condensed_element(const spectral::TriMap& map, int order) {
  if (order >= least_harmonic_order) {
    if (std::optional<CondensedElement> harmonic = harmonic_element(map, order)) return *std::move(harmonic);
  }
  return condense(order, stiffness_matrix(map, order));
}

Eigen::MatrixXd element_coefs(const spectral::TriMap& map, int order, const CondensedElement& element,
                              const Eigen::MatrixXd& boundary) {
  if (!element.interior) return harmonic_coefs(map, order, element.projection, boundary);
  Eigen::MatrixXd modes(spectral::num_tri_modes(order), boundary.cols());
  modes << boundary, *element.interior * boundary;
  return spectral::modified_to_orthogonal(order).transpose() * modes;
}

std::size_t size_of_interior(const CondensedElement& element) {
  const auto size = [](const Eigen::MatrixXd& matrix) { return static_cast<std::size_t>(matrix.size()); };
  return size(element.interior ? *element.interior : element.projection);
}

std::vector<int> first_of_shape(const std::vector<spectral::TriMap>& maps) {
  std::map<std::vector<std::int64_t>, int> firsts;
  std::vector<int> first(maps.size());
  for (std::size_t e = 0; e < maps.size(); ++e)
    first[e] = firsts.try_emplace(shape_of(maps[e]), static_cast<int>(e)).first->second;
  return first;
}

}  // namespace quadrille::stiffness
