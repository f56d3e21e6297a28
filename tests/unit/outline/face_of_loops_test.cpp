#include "outline/face_of_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
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

/// A half disc of diameter 2: a line, and an arc through `count` + 1 points, called "arc".
heal::Loop half_disc(int count) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int i = 0; i <= count; ++i) parameters.push_back(pi * i / count), points.push_back(unit(parameters.back()));
  return {{curve::segment({-1, 0}, {1, 0}), 3, "wall"},
          {curve::cubic_spline(parameters, points, {0, 1}, {0, -1}), 4, "arc"}};
}

TEST(SimplifyLoops, RecordsWhatItReplaces) {
  std::vector<heal::Loop> loops{half_disc(1000)};
  const heal::Loop old = loops[0];
  std::vector<Repair> repairs{{RepairKind::joint, 3, {1, 0}, 1e-6}};
  Report report;
  simplify_loops(loops, 1e-8, 2, repairs, report);
  EXPECT_EQ(loops[0][0].curve.poles, old[0].curve.poles);
  EXPECT_LT(loops[0][1].curve.poles.size(), 40U);
  EXPECT_EQ(loops[0][1].curve.poles.back(), old[1].curve.poles.back());
  EXPECT_EQ(loops[0][1].name, "arc");
  ASSERT_EQ(repairs.size(), 2U);
  EXPECT_EQ(repairs[1].kind, RepairKind::fit);
  EXPECT_EQ(repairs[1].cad_edge, 4);
  EXPECT_GT(repairs[1].distance, 0);
  EXPECT_LE(repairs[1].distance, 2e-8);
  const auto entry = [&](const std::string& key) {
    for (const auto& [name, value] : report.entries())
      if (name == key) return value;
    return Report::Value(std::string("absent"));
  };
  EXPECT_EQ(std::get<long long>(entry("fit.curves")), 1);
  EXPECT_EQ(std::get<long long>(entry("fit.knots_before")), 999);
  EXPECT_LT(std::get<long long>(entry("fit.knots_after")), 30);
  EXPECT_EQ(std::get<double>(entry("fit.greatest")), repairs[1].distance / 2);
  EXPECT_EQ(std::get<std::string>(entry("heal.repair.1.kind")), "fit");
  EXPECT_EQ(std::get<long long>(entry("heal.repairs")), 2);
}

TEST(SimplifyLoops, LeavesTheRestAlone) {
  for (const double tolerance : {0.0, 1e-8}) {
    std::vector<heal::Loop> loops{half_disc(tolerance == 0 ? 1000 : 20)};
    const heal::Loop old = loops[0];
    std::vector<Repair> repairs;
    Report report;
    simplify_loops(loops, tolerance, 2, repairs, report);
    for (int i = 0; i < 2; ++i) EXPECT_EQ(loops[0][i].curve.poles, old[i].curve.poles);
    EXPECT_TRUE(repairs.empty());
  }
}

heal::Loop square(Vec2 low, double side, bool is_hole = false) {
  std::vector<Vec2> p{low, low + Vec2{side, 0}, low + Vec2{side, side}, low + Vec2{0, side}};
  if (is_hole) std::swap(p[1], p[3]);
  heal::Loop loop;
  for (size_t i = 0; i < 4; ++i) loop.push_back({curve::segment(p[i], p[(i + 1) % 4]), static_cast<int>(i), ""});
  return loop;
}

Vec2 start_of(const heal::Loop& loop) { return loop.front().curve.poles.front(); }

TEST(FacePieces, LargestPieceFirstAndEachHoleInItsOwn) {
  const auto pieces = face_pieces({square({0, 0}, 2), square({0.5, 0.5}, 0.1, true), square({2, 2}, 3),
                                   square({4, 4}, 0.2, true), square({4, 3}, 0.2, true)});
  ASSERT_EQ(pieces.size(), 2U);
  ASSERT_EQ(pieces[0].size(), 3U);
  EXPECT_EQ(start_of(pieces[0][0]), (Vec2{2, 2}));
  EXPECT_EQ(start_of(pieces[0][1]), (Vec2{4, 4}));
  EXPECT_EQ(start_of(pieces[0][2]), (Vec2{4, 3}));
  ASSERT_EQ(pieces[1].size(), 2U);
  EXPECT_EQ(start_of(pieces[1][1]), (Vec2{0.5, 0.5}));
}

TEST(FacePieces, EqualPiecesKeepTheirOrder) {
  const auto pieces = face_pieces({square({0, 0}, 1), square({1, 1}, 1 + 1e-9)});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(start_of(pieces[0][0]), (Vec2{0, 0}));
}

TEST(FacePieces, APieceInTheHoleOfAnotherIsItsOwn) {
  const auto pieces = face_pieces({square({0, 0}, 9), square({3, 3}, 3, true), square({3, 3}, 1)});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size(), 2U);
}

using namespace testing_faces;

/// A square of side 10 with a regular polygon of `sides` sides as a hole; `radius` of its corners.
CadFace with_hole(int sides, double radius) {
  std::vector<Vec2> hole;
  for (int k = 0; k < sides; ++k) hole.push_back(Vec2{5, 5} + radius * unit(-2 * pi * k / sides));
  return make_face({polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon(hole)});
}

int num_corners(const CadFace& face) {
  return static_cast<int>(
      std::count_if(face.joints.begin(), face.joints.end(), [](const Joint& joint) { return joint.is_corner; }));
}

TEST(SmoothPolylines, small_kinks_of_a_closed_polyline_are_no_corners) {
  CadFace face = with_hole(12, 0.4);  // sides of 0.2, the fiftieth of the diameter is 0.28
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 12);
  EXPECT_EQ(num_corners(face), 4);
}

TEST(SmoothPolylines, few_kinks_stay_corners) {
  CadFace face = with_hole(12, 0.4);
  EXPECT_EQ(smooth_polylines(face, radians(43), 13), 0);
  EXPECT_EQ(num_corners(face), 16);
  EXPECT_EQ(smooth_polylines(face, radians(43), 12), 12);
}

TEST(SmoothPolylines, kinks_above_the_angle_and_long_edges_stay) {
  CadFace eight = with_hole(8, 0.3);  // 45 degrees
  EXPECT_EQ(smooth_polylines(eight, radians(43), 1), 0);
  CadFace long_edges = with_hole(12, 1);
  EXPECT_EQ(smooth_polylines(long_edges, radians(43), 1), 0);
  CadFace none = with_hole(12, 0.4);
  EXPECT_EQ(smooth_polylines(none, 0, 1), 0);
}

/// A square of side 10 whose lower side begins with `num` short edges that go up and down by 17 degrees.
CadFace with_coast(int num) {
  std::vector<Vec2> points;
  for (int k = 0; k <= num; ++k) points.push_back({2 + 0.1 * k, k % 2 == 0 ? 0 : 0.03});
  points.insert(points.begin(), {0, 0});
  for (const Vec2 corner : {Vec2{10, 0}, Vec2{10, 10}, Vec2{0, 10}}) points.push_back(corner);
  return make_face({polygon(points)});
}

TEST(SmoothPolylines, the_ends_of_an_open_polyline_stay_corners) {
  CadFace face = with_coast(8);
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 7);
  EXPECT_EQ(num_corners(face), 6);  // those of the square, and both ends
}

TEST(SmoothPolylines, seven_short_edges_are_no_polyline) {
  CadFace face = with_coast(7);
  EXPECT_EQ(smooth_polylines(face, radians(43), 1), 0);
}

}  // namespace

}  // namespace quadrille::outline
