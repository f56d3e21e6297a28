#include "export/chebyshev_lobatto.hpp"

#include <cmath>
#include <numbers>

namespace quadrille::exports {

std::vector<double> chebyshev_lobatto_points(int order) {
  std::vector<double> points;
  for (int j = 0; j <= order; ++j) points.push_back(std::sin(std::numbers::pi * (2 * j - order) / (2 * order)));
  return points;
}

}  // namespace quadrille::exports
