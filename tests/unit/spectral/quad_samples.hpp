#pragma once
// Elements that are images of the reference square [-1, 1]^2.

#include <functional>
#include <vector>

#include "base/vec2.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::spectral {

using Map = std::function<Vec2(double, double)>;

/// The Gauss-Lobatto-Legendre nodes of an element, along its first direction fastest.
inline std::vector<Vec2> sampled(int order, const Map& map) {
  std::vector<Vec2> nodes;
  for (const double b : gll_points(order))
    for (const double a : gll_points(order)) nodes.push_back(map(a, b));
  return nodes;
}

}  // namespace quadrille::spectral
