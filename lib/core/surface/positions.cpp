#include "surface/positions.hpp"

#include <algorithm>
#include <cmath>

#include "base/message_text.hpp"
#include "model/chart.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::surface {

namespace {

/// Whether x can be in the element with these nodes: curved sides leave the box of the nodes by less than its size.
bool can_contain(const Vec2* nodes, int count, Vec2 x) {
  Vec2 low = nodes[0], high = nodes[0];
  for (int i = 1; i < count; ++i) {
    low = {std::min(low.x, nodes[i].x), std::min(low.y, nodes[i].y)};
    high = {std::max(high.x, nodes[i].x), std::max(high.y, nodes[i].y)};
  }
  const double margin = std::max(high.x - low.x, high.y - low.y) / 10;
  return x.x >= low.x - margin && x.x <= high.x + margin && x.y >= low.y - margin && x.y <= high.y + margin;
}

double outside(Vec2 xi) { return std::max({-(1 + xi.x), -(1 + xi.y), xi.x + xi.y}) / 2; }

/// Where x is in the triangles.
struct Place {
  int elem = -1;
  Vec2 xi;
  double outside = 0.5;  ///< the triangle, in barycentric coordinates; polynomials are useless beyond
};

Place place_of(const Chart& chart, Vec2 x) {
  const int count = chart.nodes_per_elem();
  Place best;
  for (int e = 0; e < chart.num_elems() && best.outside > 0; ++e) {
    const Vec2* nodes = &chart.nodes[static_cast<std::size_t>(e) * count];
    if (!can_contain(nodes, count, x)) continue;
    Vec2 xi{-1.0 / 3, -1.0 / 3};
    if (!spectral::TriMap(chart.order, nodes).invert(x, xi)) continue;
    if (outside(xi) < best.outside) best = {e, xi, outside(xi)};
  }
  return best;
}

/// Of damaged files positions are named before the rules of charts are known to hold.
bool is_in_space(const CadFace& face, Vec2 x) {
  if (!face.chart || face.chart->order < 1 || face.chart->num_elems() == 0) return false;
  const Chart& chart = *face.chart;
  const auto count = static_cast<std::size_t>(chart.nodes_per_elem()) * chart.elem2vertices.size();
  return chart.nodes.size() == count && chart.space_nodes.size() == count && std::isfinite(x.x) && std::isfinite(x.y);
}

}  // namespace

Vec3 position_in_space(const CadFace& face, Vec2 x) {
  const Chart& chart = *face.chart;
  const Place place = place_of(chart, x);
  if (place.elem < 0) {
    const auto nearest = std::min_element(chart.nodes.begin(), chart.nodes.end(),
                                          [&](Vec2 a, Vec2 b) { return norm2(a - x) < norm2(b - x); });
    return chart.space_nodes[nearest - chart.nodes.begin()];
  }
  const int count = chart.nodes_per_elem();
  const Vec3* in_space = &chart.space_nodes[static_cast<std::size_t>(place.elem) * count];
  std::vector<Vec2> xy, z;
  for (int i = 0; i < count; ++i) xy.push_back({in_space[i].x, in_space[i].y}), z.push_back({in_space[i].z, 0});
  const Vec2 at = spectral::TriMap(chart.order, xy.data()).position(place.xi);
  return {at.x, at.y, spectral::TriMap(chart.order, z.data()).position(place.xi).x};
}

std::vector<double> position_in_file(const CadFace& face, Vec2 x) {
  if (!is_in_space(face, x)) return {x.x + face.origin.x, x.y + face.origin.y};
  const Vec3 in_space = position_in_space(face, x);
  return {in_space.x, in_space.y, in_space.z};
}

std::string position_text(const CadFace& face, Vec2 x) {
  return is_in_space(face, x) ? quadrille::position_text(position_in_space(face, x))
                              : quadrille::position_text(x + face.origin);
}

std::string rounded_position_text(const CadFace& face, Vec2 x) {
  return is_in_space(face, x) ? position_text(face, x) : quadrille::rounded_position_text(x + face.origin);
}

}  // namespace quadrille::surface
