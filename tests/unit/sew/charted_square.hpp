#pragma once
// A plane face that is its own chart, and curves inside it.

#include <memory>

#include "curve/nurbs.hpp"
#include "outline/face_of_loops.hpp"
#include "regions.hpp"
#include "sew/chart_nodes.hpp"

namespace quadrille::sew::testing_charts {

inline SpaceCurve lifted(const Nurbs& curve) {
  SpaceCurve result{curve.degree, curve.knots, {}, curve.weights};
  for (const Vec2 p : curve.poles) result.poles.push_back({p.x, p.y, 3});
  return result;
}

/// A square of side 2 in the plane z = 3, which is its own chart.
inline CadFace charted_square() {
  heal::RawFace raw;
  const std::vector<heal::Loop> loops{testing_regions::rectangle({0, 0}, {2, 2})};
  CadFace face = outline::face_of_loops(raw, loops, outline::curves_of(loops[0]), 0.01);
  auto chart = std::make_shared<Chart>();
  chart->elem2vertices = {{0, 1, 2}, {0, 2, 3}};
  chart->nodes = {{0, 0}, {2, 0}, {2, 2}, {0, 0}, {2, 2}, {0, 2}};
  for (const Vec2 p : chart->nodes) chart->space_nodes.push_back({p.x, p.y, 3});
  for (const Nurbs& curve : face.curves) chart->space_curves.push_back(lifted(curve));
  face.chart = chart;
  return face;
}

inline ChartCurve inner(const Nurbs& image, std::array<int, 2> faces = {0, 0}) {
  return {image, lifted(image), "", 9, faces};
}

inline ChartCurve line(Vec2 a, Vec2 b, std::array<int, 2> faces = {0, 0}) { return inner(curve::segment(a, b), faces); }

}  // namespace quadrille::sew::testing_charts
