#include "outline/wire_loop.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

heal::RawEdge edge(const Nurbs& curve, int cad_edge) {
  return {curve, curve.poles.front(), curve.poles.back(), cad_edge};
}

std::vector<heal::RawEdge> triangle() {
  return {edge(curve::segment({0, 0}, {4, 0}), 10), edge(curve::segment({4, 0}, {4, 3}), 11),
          edge(curve::segment({4, 3}, {0, 0}), 12)};
}

heal::RawFace named() {
  heal::RawFace raw;
  raw.file = "f.step";
  return raw;
}

std::string refusal(const std::vector<heal::RawEdge>& wire) {
  Report report;
  return message_of<FormatError>([&] { wire_loop(named(), wire, 1e-3, report); });
}

std::vector<int> edges_of(const Loop& loop) {
  std::vector<int> edges;
  for (const LoopCurve& c : loop) edges.push_back(c.cad_edge);
  return edges;
}

TEST(WireLoop, ClosesGapsInTheMiddle) {
  std::vector<heal::RawEdge> wire = triangle();
  wire[1] = edge(curve::segment({4, 4e-4}, {4, 3}), 11);
  Report report;
  const std::vector<Nurbs> curves = curves_of(wire_loop(named(), wire, 1e-3, report));
  EXPECT_EQ(curves[0].poles.back(), (Vec2{4, 2e-4}));
  EXPECT_EQ(curves[1].poles.front(), (Vec2{4, 2e-4}));
}

TEST(WireLoop, ClosesGapsWithoutTurningTheTangentWherePolesCoincide) {
  std::vector<heal::RawEdge> wire = triangle();
  wire[1] = edge({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{4.0004, 0}, {4.0004, 0}, {4, 2}, {4, 3}}, {1, 1, 1, 1}}, 11);
  Report report;
  const Nurbs curve = wire_loop(named(), wire, 1e-3, report)[1].curve;
  EXPECT_EQ(curve.poles[1], curve.poles[0]);
  EXPECT_NEAR(curve::tangent(curve, curve.begin()).x, 0, 1e-3);
}

TEST(WireLoop, DropsShortEdgesWithAWarning) {
  std::vector<heal::RawEdge> wire = triangle();
  wire.insert(wire.begin() + 1, edge(curve::segment({4, 0}, {4, 1e-4}), 99));
  Report report;
  EXPECT_EQ(edges_of(wire_loop(named(), wire, 1e-3, report)), (std::vector<int>{10, 11, 12}));
  ASSERT_EQ(report.warnings().size(), 1u);
}

TEST(WireLoop, SplitsCurvesWhereTheirTangentJumps) {
  Nurbs bent;  // a polyline of degree 1 with a knot at its bend
  bent.degree = 1;
  bent.knots = {0, 0, 1, 2, 2};
  bent.poles = {{4, 0}, {4, 3}, {0, 0}};
  bent.weights = {1, 1, 1};
  Report report;
  const Loop loop = wire_loop(named(), {edge(curve::segment({0, 0}, {4, 0}), 10), edge(bent, 11)}, 1e-3, report);
  EXPECT_EQ(edges_of(loop), (std::vector<int>{10, 11, 11}));
  EXPECT_EQ(loop[1].curve.poles.back(), (Vec2{4, 3}));
}

TEST(WireLoop, RefusesOpenWiresAndVerticesOffTheirCurves) {
  std::vector<heal::RawEdge> open = triangle();
  open.pop_back();
  EXPECT_NE(refusal(open).find("the wire is open: it begins at (0, 0) and ends at (4, 3)"), std::string::npos);
  std::vector<heal::RawEdge> apart = triangle();
  apart[1] = edge(curve::segment({4, 0.1}, {4, 3}), 11);
  EXPECT_NE(refusal(apart).find("no edge continues edge 10 at (4, 0)"), std::string::npos);
  std::vector<heal::RawEdge> off = triangle();
  off[2].start = {4, 3.5};
  EXPECT_NE(refusal(off).find("edge 12: its vertex at (4, 3.5) lies 0.5 off its curve"), std::string::npos);
  EXPECT_NE(refusal({edge(curve::segment({1, 1}, {1, 1.0001}), 3)}).find("is a point"), std::string::npos);
}

TEST(WireLoop, ReversedBeginsWithTheSameCurve) {
  Report report;
  const Loop back = reversed(wire_loop(named(), triangle(), 1e-3, report));
  EXPECT_EQ(edges_of(back), (std::vector<int>{10, 12, 11}));
  EXPECT_EQ(back[0].curve.poles.front(), (Vec2{4, 0}));
  EXPECT_EQ(back[1].curve.poles.front(), (Vec2{0, 0}));
}

}  // namespace
}  // namespace quadrille::outline
