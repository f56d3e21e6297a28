#include "spectral/bernstein_cube.hpp"

#include <algorithm>
#include <cmath>

#include "spectral/bernstein_tables.hpp"

namespace quadrille::spectral {

namespace {

/// Halves along one direction: `low` becomes the lower half, the upper one is returned.
std::vector<double> halved(std::vector<double>& low, int width, int direction) {
  std::vector<double> high = low;
  const int stride = direction == 0 ? 1 : direction == 1 ? width : width * width;
  const int a = direction == 0 ? width : 1, b = direction == 2 ? width : width * width;
  for (int j = 0; j < width; ++j)
    for (int i = 0; i < width; ++i) halve_line(&low[j * b + i * a], &high[j * b + i * a], width, stride);
  return high;
}

std::vector<BernsteinCube> eighths(const BernsteinCube& whole, double error) {
  std::vector<BernsteinCube> parts{{whole.degree, whole.coefs, error}};
  for (int direction = 0; direction < 3; ++direction)
    for (std::size_t p = 0, count = parts.size(); p < count; ++p)
      parts.push_back({whole.degree, halved(parts[p].coefs, whole.degree + 1, direction), error});
  return parts;
}

/// The least of the coefficients that are values of the polynomial: those at the corners.
double least_corner(const BernsteinCube& p) {
  const int d = p.degree, w = d + 1;
  double least = p.coefs[0];
  for (const int k : {0, d})
    for (const int j : {0, d})
      for (const int i : {0, d}) least = std::min(least, p.coefs[(k * w + j) * w + i]);
  return least;
}

}  // namespace

double lower_bound(const BernsteinCube& polynomial, int depth) {
  const auto [least, greatest] = std::minmax_element(polynomial.coefs.begin(), polynomial.coefs.end());
  const double bound = *least - polynomial.error;
  if (bound > 0 || depth <= 0 || least_corner(polynomial) - polynomial.error <= 0) return bound;
  const double largest = std::max(std::abs(*least), std::abs(*greatest)) + polynomial.error;
  double result = largest;
  for (const BernsteinCube& part :
       eighths(polynomial, polynomial.error + 3 * polynomial.degree * unit_roundoff * largest))
    result = std::min(result, lower_bound(part, depth - 1));
  return result;
}

}  // namespace quadrille::spectral
