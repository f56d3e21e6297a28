#include "stiffness/element_shapes.hpp"

#include <cmath>
#include <complex>
#include <cstdint>
#include <map>

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

std::vector<int> first_of_shape(const std::vector<spectral::TriMap>& maps) {
  std::map<std::vector<std::int64_t>, int> firsts;
  std::vector<int> first(maps.size());
  for (std::size_t e = 0; e < maps.size(); ++e)
    first[e] = firsts.try_emplace(shape_of(maps[e]), static_cast<int>(e)).first->second;
  return first;
}

}  // namespace quadrille::stiffness
