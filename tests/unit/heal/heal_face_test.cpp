#include "heal/heal_face.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "curve/pole_box.hpp"
#include "curve/project.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {

namespace {

// A C1 cubic from (0, 0) to (6, 1). The poles beside its double knot are exchanged if `back` > 0, by that distance.
Nurbs wave(double back) {
  const Vec2 a{3 + back / 2, 0.5}, b{3 - back / 2, 0.5};
  return {3, {0, 0, 0, 0, 1, 1, 2, 2, 2, 2}, {{0, 0}, {1, 0}, a, b, {5, 1}, {6, 1}}, {1, 1, 1, 1, 1, 1}};
}

TEST(Unfold, PutsPolesInOrder) {
  Nurbs curve = wave(1e-4);
  EXPECT_NEAR(unfold(curve, 2e-4), 1e-4, 1e-15);
  EXPECT_EQ(curve.poles, wave(-1e-4).poles);
  EXPECT_EQ(unfold(curve, 2e-4), 0);
}

TEST(Unfold, OneExchangeCanNeedAnother) {
  const std::vector<Vec2> sorted{{0, 0}, {1, 0}, {1.1, 0}, {1.2, 0}, {1.3, 0}, {3, 0}};
  Nurbs curve = wave(0);
  curve.poles = {sorted[0], sorted[2], sorted[3], sorted[4], sorted[1], sorted[5]};
  EXPECT_NEAR(unfold(curve, 0.4), 0.3, 1e-15);
  EXPECT_EQ(curve.poles, sorted);
}

TEST(Unfold, KeepsWhatWouldMoveTooFar) {
  Nurbs curve = wave(1e-4);
  EXPECT_EQ(unfold(curve, 9e-5), 0);
  EXPECT_EQ(curve.poles, wave(1e-4).poles);
}

TEST(Unfold, KeepsCurvesThatTurn) {
  // A leg against one of its neighbours only is a turn: the wire goes on to the other side.
  Nurbs turn = wave(0);
  turn.poles = {{0, 0}, {1, 0}, {1.1, 0}, {1.05, 0.1}, {0, 0.2}, {-1, 0.2}};
  const std::vector<Vec2> old = turn.poles;
  EXPECT_EQ(unfold(turn, 1), 0);
  EXPECT_EQ(turn.poles, old);
}

TEST(Unfold, HealingReportsIt) {
  RawFace raw = raw_face({wave(1e-4), curve::segment({6, 1}, {6, 5}), curve::segment({6, 5}, {0, 0})});
  Report report;
  const auto repairs = heal_face(raw, {1e-4}, 10, report);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::fold);
  EXPECT_NEAR(repairs[0].distance, 1e-4, 1e-15);
  EXPECT_EQ(repairs[0].position, (Vec2{3 + 5e-5, 0.5}));
  EXPECT_TRUE(heal_face(raw, {1e-4}, 10, report).empty());
}

// A cubic arch from (4, 0) to (0, 0) with these inner knots in (0, 1), which are breaks.
Nurbs arch(const std::vector<double>& inner) {
  Nurbs curve;
  curve.degree = 3;
  curve.knots.assign(4, 0);
  curve.knots.insert(curve.knots.end(), inner.begin(), inner.end());
  curve.knots.insert(curve.knots.end(), 4, 1);
  const size_t count = curve.knots.size() - 4;
  for (size_t i = 0; i < count; ++i) {
    const double t = (curve.knots[i + 1] + curve.knots[i + 2] + curve.knots[i + 3]) / 3;
    curve.poles.push_back({4 - 4 * t, std::sin(pi * t) * (1 + t)});
  }
  curve.poles.back().y = 0;
  curve.weights.assign(count, 1);
  return curve;
}

double greatest_distance(const Nurbs& a, const Nurbs& b) {
  double greatest = 0;
  for (int i = 0; i <= 100; ++i) greatest = std::max(greatest, curve::project(b, curve::point(a, i / 100.0)).distance);
  return greatest;
}

void expect_merged(const std::vector<double>& inner, size_t num_poles, double most) {
  const Nurbs old = arch(inner);
  Nurbs curve = old;
  const auto merged = merge_knots(curve, most);
  ASSERT_TRUE(merged);
  EXPECT_GT(merged->length, 0);
  EXPECT_LE(merged->length, most);
  EXPECT_EQ(curve.poles.size(), num_poles);
  EXPECT_EQ(curve.knots.size(), num_poles + 4);
  EXPECT_EQ(curve.weights.size(), num_poles);
  EXPECT_EQ(curve.poles.front(), old.poles.front());
  EXPECT_EQ(curve.poles.back(), old.poles.back());
  EXPECT_LE(greatest_distance(old, curve), merged->length);
  EXPECT_FALSE(merge_knots(curve, most));
}

TEST(MergeKnots, TwoSimpleKnotsBecomeADoubleOne) { expect_merged({0.5, 0.5 + 1e-6}, 6, 1e-4); }

TEST(MergeKnots, AKnotLosesPolesBeyondTheDegree) {
  expect_merged({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6}, 7, 1e-4);
  expect_merged({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6, 0.5 + 2e-6, 0.5 + 2e-6}, 7, 1e-4);
  expect_merged({0.5, 0.5, 0.5 + 1e-12, 0.5 + 1e-12}, 7, 1e-4);
}

TEST(MergeKnots, KnotsNearAnEndGoThere) {
  expect_merged({1e-6, 1e-6, 0.5, 0.5}, 6, 1e-4);
  expect_merged({0.5, 0.5, 1 - 1e-6, 1 - 1e-6}, 6, 1e-4);
  expect_merged({1e-6, 1e-6, 1 - 1e-6, 1 - 1e-6}, 4, 1e-4);
}

TEST(MergeKnots, KnotsFurtherApartAndShortCurvesStay) {
  Nurbs curve = arch({0.5, 0.5, 0.5 + 1e-3, 0.5 + 1e-3});
  const std::vector<double> knots = curve.knots;
  EXPECT_FALSE(merge_knots(curve, 1e-3));
  EXPECT_FALSE(merge_knots(curve, 100));
  EXPECT_EQ(curve.knots, knots);
}

TEST(MergeKnots, KnotsThatAreNoBreaksStay) {
  Nurbs line{3, {0, 0, 0, 0, 0.5, 0.5 + 1e-9, 1, 1, 1, 1}, {}, {1, 1, 1, 1, 1, 1}};
  for (size_t i = 0; i < 6; ++i)
    line.poles.push_back({(line.knots[i + 1] + line.knots[i + 2] + line.knots[i + 3]) / 3, 0});
  EXPECT_FALSE(merge_knots(line, 1e-4));
}

TEST(MergeKnots, HealingReportsIt) {
  RawFace raw = raw_face({curve::segment({0, 0}, {0, -3}), curve::segment({0, -3}, {4, -3}),
                          curve::segment({4, -3}, {4, 0}), arch({0.5, 0.5, 0.5 + 1e-6, 0.5 + 1e-6})});
  Report report;
  const auto repairs = heal_face(raw, {}, 6, report);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::knot);
  EXPECT_EQ(repairs[0].cad_edge, 3);
  EXPECT_TRUE(heal_face(raw, {}, 6, report).empty());
}

// A plate of 8 x 6.
const std::vector<Vec2> plate{{0, 0}, {8, 0}, {8, 6}, {0, 6}};
constexpr double diameter = 10;

std::vector<Repair> heal(RawFace& raw, double tolerance = -1) {
  Report report;
  return heal_face(raw, {tolerance}, diameter, report);
}

std::string refusal(RawFace raw, double tolerance = -1) {
  return message_of<FormatError>([&] { heal(raw, tolerance); });
}

// The plate with an edge that begins off the end of its neighbour.
RawFace with_gap(Vec2 gap) {
  RawFace raw = raw_polygon(plate);
  raw.wires[0][1] = raw_edge(curve::segment(Vec2{8, 0} + gap, {8, 6}), 1);
  return raw;
}

// A slot: two lines and two half circles, whose radius is too large by `error`.
RawFace slot(double error) {
  const double r = 1 + error;
  return raw_face({curve::segment({0, -1}, {5, -1}), curve::circular_arc({5, 0}, r, -half_pi, half_pi),
                   curve::segment({5, 1}, {0, 1}), curve::circular_arc({0, 0}, r, half_pi, 3 * half_pi)});
}

std::vector<Vec2> poles_of(const RawFace& raw) {
  std::vector<Vec2> poles;
  for (const RawEdge& edge : raw.wires[0]) poles.insert(poles.end(), edge.curve.poles.begin(), edge.curve.poles.end());
  return poles;
}

TEST(HealFace, CurvesThatMeetAreNotTouched) {
  RawFace raw = raw_polygon(plate);
  EXPECT_TRUE(heal(raw).empty());
  EXPECT_EQ(poles_of(raw), poles_of(raw_polygon(plate)));
  RawFace rounded = with_gap({0, 5e-7});
  EXPECT_TRUE(heal(rounded).empty());
  EXPECT_EQ(poles_of(rounded), poles_of(with_gap({0, 5e-7})));
}

TEST(HealFace, LinesMeetExactlyAndDoNotTurn) {
  RawFace raw = with_gap({3e-5, 4e-5});
  const auto repairs = heal(raw, 1e-4);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::joint);
  EXPECT_EQ(repairs[0].cad_edge, 0);
  EXPECT_NEAR(repairs[0].distance, 4e-5, 1e-9);
  EXPECT_EQ(greatest_gap(raw), 0);
  EXPECT_EQ(raw.wires[0][0].curve.poles[1].y, 0);
}

TEST(HealFace, ASecondHealingChangesNothing) {
  for (RawFace raw : {slot(2e-5), slot(-2e-5), with_gap({3e-5, 4e-5}), with_gap({-5e-5, 0})}) {
    EXPECT_FALSE(heal(raw).empty());
    EXPECT_EQ(greatest_gap(raw), 0);
    RawFace again = raw;
    EXPECT_TRUE(heal(again).empty());
    EXPECT_EQ(poles_of(again), poles_of(raw));
  }
}

TEST(HealFace, ASlotKeepsItsLinesItsArcsAndItsSymmetry) {
  for (const double error : {5e-5, -5e-5}) {
    RawFace raw = slot(error);
    EXPECT_EQ(heal(raw).size(), 4U);
    const auto& wire = raw.wires[0];
    ASSERT_EQ(wire.size(), 4U);
    EXPECT_NEAR(distance(wire[0].curve.poles[0], {0, -1}), 0, 1e-15);
    EXPECT_NEAR(distance(wire[0].curve.poles[1], {5, -1}), 0, 1e-15);
    for (const int arc : {1, 3}) EXPECT_EQ(curve::carrier_of(wire[arc].curve).kind, curve::CurveKind::arc);
    for (size_t i = 0; i < wire[1].curve.poles.size(); ++i) {
      const Vec2 p = wire[1].curve.poles[i], q = wire[3].curve.poles[i];
      EXPECT_NEAR(distance(p, Vec2{5, 0} - q), 0, 1e-14);
      EXPECT_NEAR(p.y, -wire[1].curve.poles[wire[1].curve.poles.size() - 1 - i].y, 1e-14);
    }
  }
}

TEST(HealFace, ChamfersBelowTheToleranceBecomeCorners) {
  RawFace raw = raw_polygon({{0, 0}, {8 - 4e-5, 0}, {8, 4e-5}, {8, 6}, {0, 6}});
  Report report;
  const auto repairs = heal_face(raw, {}, diameter, report);
  ASSERT_EQ(repairs.size(), 2U);
  EXPECT_EQ(repairs[0].kind, RepairKind::edge);
  EXPECT_EQ(report.warnings()[0].code, "W-CAD-005");
  EXPECT_EQ(raw.wires[0].size(), 4U);
  EXPECT_EQ(raw.wires[0][0].curve.poles[1], (Vec2{8, 0}));
}

TEST(HealFace, TheTolerancesOfTheShapeDoNotRemoveEdges) {
  RawFace raw = raw_polygon({{0, 0}, {8 - 4e-3, 0}, {8, 4e-3}, {8, 6}, {0, 6}});
  raw.shape_tolerance = 0.01;
  EXPECT_TRUE(heal(raw).empty());
  EXPECT_EQ(heal(raw, 1e-3).size(), 2U);
}

TEST(HealFace, VerticesOffCurvesThatMeetAreMoved) {
  RawFace raw = raw_polygon(plate);
  raw.wires[0][0].end = raw.wires[0][1].start = {8, 9e-5};
  const auto repairs = heal(raw);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::vertex);
  EXPECT_EQ(raw.wires[0][0].end, (Vec2{8, 0}));
  RawFace far = raw_polygon(plate);
  far.wires[0][0].end = {8, 0.02};
  expect_contains(refusal(far),
                  "edge 0: its vertex at (8, 0.02) lies 0.02 off its curve (0.002 diameters; the "
                  "tolerance is 1e-05): give --heal-tolerance 0.0021");
}

TEST(HealFace, EdgesAreProjectedToThePlane) {
  RawFace raw = raw_polygon(plate);
  raw.wires[0][2].height = 0.01;
  const auto repairs = heal(raw);
  ASSERT_EQ(repairs.size(), 1U);
  EXPECT_EQ(repairs[0].kind, RepairKind::plane);
  EXPECT_EQ(repairs[0].distance, 0.01);
  expect_contains(refusal(raw, 1e-4), "edge 2 leaves the plane of the face by 0.01");
  expect_contains(refusal(raw, 1e-4), "give --heal-tolerance 0.0011");
  raw.wires[0][2].height = 0.1;
  expect_contains(refusal(raw), "healing moves nothing further than 0.005): draw it anew");
}

TEST(HealFace, GapsAreRefusedWithPlaceSizeAndRemedy) {
  expect_contains(refusal(with_gap({0.01, 0})), "the wire is open");
  expect_contains(refusal(with_gap({0, -1.5e-4}), 1e-5),
                  "edges 0 and 1 are 0.00015 apart at (8, -7.5e-05) (1.5e-05 diameters; the tolerance is 1e-05): give "
                  "--heal-tolerance 1.6e-05");
}

TEST(HealFace, ToleranceZeroHealsNothing) {
  RawFace raw = with_gap({3e-5, 4e-5});
  EXPECT_TRUE(heal(raw, 0).empty());
  EXPECT_EQ(poles_of(raw), poles_of(with_gap({3e-5, 4e-5})));
}

TEST(HealFace, TheShapeStatesTheTolerance) {
  RawFace raw = with_gap({2e-3, 0});
  EXPECT_NE(refusal(raw), "");
  raw.shape_tolerance = 1e-3;
  EXPECT_EQ(heal(raw).size(), 1U);
  EXPECT_EQ(greatest_gap(raw), 0);
}

TEST(HealFace, LargeRepairsAreReportedWithAWarning) {
  RawFace raw = with_gap({0.02, 0});
  raw.shape_tolerance = 0.01;
  Report report;
  heal_face(raw, {}, diameter, report);
  ASSERT_EQ(report.warnings().size(), 1U);
  EXPECT_EQ(report.warnings()[0].code, "W-CAD-006");
}

}  // namespace

}  // namespace quadrille::heal
