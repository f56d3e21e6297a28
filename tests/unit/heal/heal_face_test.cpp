#include "heal/heal_face.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/carrier.hpp"
#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

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
