#pragma once
// Block layouts on the unit sphere (chart_samples.hpp), for the writer of STEP files.

#include <cmath>

#include "../chart_samples.hpp"
#include "../curved_surfaces.hpp"
#include "../support/block_sides.hpp"
#include "model/block_layout.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::samples {

/// The square [a, a + 1/2]^2 of the chart, in which the whole sphere is one surface with a seam and poles at the
/// chart's origin and at infinity, or the patch with the chart's coordinates as parameters.
inline CadFace square_on_sphere(double a, bool is_whole) {
  CadFace f = face();
  f.name = "patch";
  f.diameter /= 2;
  const auto moved = [a](Vec2 x) { return 0.5 * x + Vec2{a, a}; };
  for (Nurbs& curve : f.curves)
    for (Vec2& pole : curve.poles) pole = moved(pole);
  for (Joint& joint : f.joints) joint.position = moved(joint.position);
  const std::vector<Vec2> vertices{moved({0, 0}), moved({1, 0}), moved({1, 1}), moved({0, 1}), moved({0.5, 0.5})};
  Chart chart = chart_on_sphere(f, vertices, {{0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}}, 8, vertices[0], vertices[2]);
  if (is_whole) {
    chart.surfaces = {tests::sphere(1)};
    for (std::size_t i = 0; i < chart.uv.size(); ++i) {
      const Vec2 x = chart.nodes[i];
      const double u = norm(x) > 0 ? std::atan2(x.y, x.x) : 0.0;
      const Vec2 guess{u < 0 ? u + 2 * M_PI : u, M_PI / 2 - 2 * std::atan(norm(x))};
      chart.uv[i] = norm(x) > 0 ? surface::project(chart.surfaces[0], chart.space_nodes[i], guess).uv : guess;
    }
  }
  f.chart = std::make_shared<const Chart>(std::move(chart));
  return f;
}

/// Two blocks, left and right of a line; one block if `is_one`.
inline BlockLayout blocks_on_sphere(double a, bool is_whole, bool is_one) {
  BlockLayout layout;
  layout.face = square_on_sphere(a, is_whole);
  const auto at = [a](double x, double y) { return Vec2{a + x / 2, a + y / 2}; };
  const auto add = [&](Vec2 x, NodeKind kind, int curve, double t) {
    layout.nodes.push_back({x, kind, kind == NodeKind::corner ? 1 : 2, curve, t});
  };
  const auto arc = [&](int from, int to, int curve, double t0, double t1) {
    layout.arcs.push_back({from, to, curve < 4, 0, {{curve, t0, t1}}});
  };
  for (int k = 0; k < 4; ++k)
    add(layout.face.curves[k].poles.front(), NodeKind::corner, k, layout.face.curves[k].begin());
  const auto whole = [&](int from, int to, int curve) {
    arc(from, to, curve, layout.face.curves[curve].begin(), layout.face.curves[curve].end());
  };
  if (is_one) {
    for (int k = 0; k < 4; ++k) whole(k, (k + 1) % 4, k);
    layout.block2nodes = {{0, 1, 2, 3}};
    layout.block2arcs = {block_sides({0, 1, 2, 3})};
    return layout;
  }
  const auto middle = [&](int curve) {
    return (layout.face.curves[curve].begin() + layout.face.curves[curve].end()) / 2;
  };
  add(at(0.5, 0), NodeKind::boundary, 0, middle(0));
  add(at(0.5, 1), NodeKind::boundary, 2, middle(2));
  layout.splines = {line(at(0.5, 0), at(0.5, 1))};
  arc(0, 4, 0, layout.face.curves[0].begin(), middle(0));
  arc(4, 1, 0, middle(0), layout.face.curves[0].end());
  whole(1, 2, 1);
  arc(2, 5, 2, layout.face.curves[2].begin(), middle(2));
  arc(5, 3, 2, middle(2), layout.face.curves[2].end());
  whole(3, 0, 3);
  arc(4, 5, 4, layout.splines[0].begin(), layout.splines[0].end());
  layout.block2nodes = {{0, 4, 5, 3}, {4, 1, 2, 5}};
  layout.block2arcs = {block_sides({0, 6, 4, 5}), block_sides({1, 2, 3, -7})};
  return layout;
}

/// Area of the sphere over the rectangle [x0, x1] x [y0, y1] of the chart: the integral of 4 / (1 + r^2)^2.
inline double area_on_sphere(double x0, double x1, double y0, double y1) {
  constexpr int count = 400;
  double sum = 0;
  for (int i = 0; i < count; ++i)
    for (int j = 0; j < count; ++j) {
      const Vec2 x{x0 + (x1 - x0) * (i + 0.5) / count, y0 + (y1 - y0) * (j + 0.5) / count};
      sum += 4 / ((1 + norm2(x)) * (1 + norm2(x)));
    }
  return sum * (x1 - x0) * (y1 - y0) / (count * count);
}

}  // namespace quadrille::samples
