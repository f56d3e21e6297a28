#include "placement/keep_clearance.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/error.hpp"
#include "node_samples.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

TEST(WallClearance, ReadsNameAndLength) {
  const NamedClearance wall = parse_clearance("a=b=0.5");
  EXPECT_EQ(wall.name, "a=b");
  EXPECT_EQ(wall.clearance, 0.5);
  for (const char* text : {"wall", "=1", "wall=", "wall=0", "wall=-1", "wall=x", "wall=1x", "wall=inf"})
    EXPECT_THROW(parse_clearance(text), UsageError) << text;
}

TEST(WallClearance, UnknownNamesAreRefused) {
  const CadFace disc = make_face({circle({0, 0}, 1)});
  EXPECT_THROW(wall_clearances(disc, {{"roof", 1}}), UsageError);
  EXPECT_EQ(wall_clearances(disc, {{"0", 0.25}}).at(0).curves, std::vector<int>{0});
}

TEST(WallClearance, CurvesOfSeveralWallsHaveTheGreatestClearance) {
  const CadFace face = make_face({circle({0, 0}, 2), hole({0, 0}, 1)});
  EXPECT_EQ(clearance_of_curves(face, {{{0}, 0.2}, {{0, 1}, 0.1}}), (std::vector<double>{0.2, 0.1}));
  EXPECT_EQ(clearance_of_curves(face, {{{1}, 0.3}}), (std::vector<double>{0, 0.3}));
}

using namespace testing_faces;

/// The nodes after their move away from curves with this clearance.
struct Kept {
  Kept(const CadFace& face, CriticalPoints start, const std::vector<WallClearance>& walls,
       std::vector<bool> may_move = {}, const LogScale& log_scale = {})
      : points(std::move(start)) {
    may_move.resize(points.critical_points.size(), may_move.empty());
    keep_clearance(face, walls, log_scale, may_move, points, report);
  }
  Vec2 operator[](int k) const { return points.critical_points[k].position; }

  CriticalPoints points;
  Report report;
};

CadFace disc() { return make_face({circle({0, 0}, 1)}); }

/// A box of 8 x 4 with two holes of radius 1 whose centres are 2.5 apart.
CadFace two_holes() {
  return make_face({polygon({{-4, -2}, {4, -2}, {4, 2}, {-4, 2}}), hole({-1.25, 0}, 1), hole({1.25, 0}, 1)});
}
constexpr int first_hole = 4, second_hole = 5;

TEST(KeepClearance, MovesTheShortestWayOut) {
  const Kept kept(disc(), points_at({0.9 * unit(0.3), 0.5 * unit(2)}), {{{0}, 0.25}});
  EXPECT_NEAR(distance(kept[0], 0.75 * unit(0.3)), 0, 1e-7);
  EXPECT_EQ(kept[1], 0.5 * unit(2)) << "it has its clearance";
  ASSERT_EQ(kept.points.changes.size(), 1u);
  EXPECT_EQ(kept.points.changes[0].kind, ChangeKind::place);
  EXPECT_EQ(kept.points.critical_points[0].source, NodeSource::place);
  EXPECT_EQ(kept.points.form, NodeForm::phase);
  EXPECT_EQ(kept.points.zeros.size(), 2u);
  EXPECT_TRUE(kept.report.warnings().empty());
}

TEST(KeepClearance, ChangesNothingWhereNoNodeIsTooNear) {
  for (const std::vector<WallClearance>& walls :
       {std::vector<WallClearance>{}, std::vector<WallClearance>{{{0}, 0.05}}}) {
    const Kept kept(disc(), points_at({0.9 * unit(0.3)}), walls);
    EXPECT_TRUE(kept.points.changes.empty());
    EXPECT_EQ(kept.points.form, NodeForm::harmonic);
  }
}

TEST(KeepClearance, NodesThatMayNotMoveStay) {
  const Kept kept(disc(), points_at({0.9 * unit(0.3), 0.9 * unit(2)}), {{{0}, 0.25}}, {false, true});
  EXPECT_EQ(kept[0], 0.9 * unit(0.3));
  EXPECT_NEAR(norm(kept[1]), 0.75, 1e-7);
}

TEST(KeepClearance, OfTwoWallsAreMissedByTheSameAmount) {
  const Vec2 start{0.05, 1.2};
  const Kept kept(two_holes(), points_at({start}, 5), {{{first_hole}, 0.85}, {{second_hole}, 0.8}});
  const double first = 1.85 - distance(kept[0], {-1.25, 0}), second = 1.8 - distance(kept[0], {1.25, 0});
  EXPECT_NEAR(first, second, 1e-6);
  EXPECT_GT(first, 0.01) << "the way out between them is longer than what the node misses";
  EXPECT_LT(first, 0.05);
  EXPECT_NEAR(distance(kept[0], start), 1.8 - distance(start, {1.25, 0}), 1e-6);
  EXPECT_TRUE(kept.report.warnings().empty()) << "less than a tenth";
}

TEST(KeepClearance, OfTheNearerWallIsKeptBesideAnother) {
  const Kept kept(two_holes(), points_at({{-2.4, 0.1}}, 5), {{{first_hole, second_hole}, 0.9}});
  EXPECT_NEAR(distance(kept[0], {-1.25, 0}), 1.9, 1e-6);
}

TEST(KeepClearance, BetweenWallsWithoutRoomTheNodeIsInTheMiddle) {
  const Kept kept(two_holes(), points_at({{0.1, 0}}, 5), {{{first_hole, second_hole}, 0.5}});
  EXPECT_NEAR(kept[0].x, 0, 1e-6);
  ASSERT_EQ(kept.report.warnings().size(), 1u);
  EXPECT_EQ(kept.report.warnings()[0].code, "W-PLACE-003");
  EXPECT_NE(kept.report.warnings()[0].message.find("is 0.25 from"), std::string::npos);
}

TEST(KeepClearance, OneWarningNamesTheMostCrowdedNode) {
  const Kept kept(two_holes(), points_at({{0.1, 0}, {0, 0.4}}, 5), {{{first_hole, second_hole}, 0.6}});
  ASSERT_EQ(kept.report.warnings().size(), 1u);
  EXPECT_EQ(kept.report.warnings()[0].message.find("2 irregular nodes"), 0u);
}

TEST(KeepClearance, NodesThatMoveTowardsEachOtherKeepHalfOfTheirDistance) {
  const CadFace channel = make_face({polygon({{0, 0}, {4, 0}, {4, 1}, {0, 1}})});
  const Kept kept(channel, points_at({{2, 0.3}, {2, 0.7}}), {{{0}, 0.45}});
  EXPECT_NEAR(distance(kept[0], {2, 0.45}), 0, 1e-6);
  const Kept both(channel, points_at({{2, 0.3}, {2.1, 0.7}}), {{{0}, 0.7}, {{2}, 0.7}});
  EXPECT_NEAR(distance(both[0], both[1]), distance(Vec2{2, 0.3}, Vec2{2.1, 0.7}) / 2, 1e-6);
}

TEST(KeepClearance, BoundariesWithoutLayersKeepHalfOfTheirDistance) {
  const Kept kept(two_holes(), points_at({{-1.25, 1.2}}, 5), {{{first_hole}, 0.9}});
  EXPECT_NEAR(kept[0].y, 1.6, 1e-6) << "0.4 below the upper side";
  EXPECT_EQ(kept.report.warnings().size(), 1u);
}

TEST(KeepClearance, AMoveIsNotLongerThanWhatTheNodeMisses) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}})});
  const Kept kept(face, points_at({{0.5, 0.5}}), {{{0, 3}, 1}});
  EXPECT_NEAR(distance(kept[0], {0.5, 0.5}), 0.5, 1e-6);
  EXPECT_NEAR(kept[0].x, kept[0].y, 1e-6);
}

TEST(KeepClearance, SymmetricNodesMoveSymmetrically) {
  const Kept kept(two_holes(), points_at({{-0.3, 1.1}, {0.3, 1.1}, {-0.3, -1.1}, {0.3, -1.1}, {0, 0.3}, {0, -0.3}}, 5),
                  {{{first_hole, second_hole}, 1}});
  for (int k = 1; k < 4; ++k) {
    EXPECT_NEAR(std::abs(kept[k].x), std::abs(kept[0].x), 1e-13);
    EXPECT_NEAR(std::abs(kept[k].y), std::abs(kept[0].y), 1e-13);
  }
  for (int k = 4; k < 6; ++k) EXPECT_NEAR(kept[k].x, 0, 1e-13);
}

TEST(KeepClearance, PairsOnAMirrorAxisPassToBothSidesOfIt) {
  const Kept kept(two_holes(), points_at({{2.3, 0}, {2.5, 0}}, 5), {{{second_hole}, 0.45}});
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(distance(kept[k], {1.25, 0}), 1.45, 1e-7);
  EXPECT_GT(kept[0].y, 0.1);
  EXPECT_NEAR(distance(kept[1], {kept[0].x, -kept[0].y}), 0, 1e-13);
  EXPECT_TRUE(kept.report.warnings().empty());
  ASSERT_EQ(kept.points.changes.size(), 4u) << "turned and moved out";
  EXPECT_NE(kept.points.changes[0].reason.find("to both sides of a mirror axis"), std::string::npos);
  EXPECT_NEAR(distance(kept.points.changes[0].after[0].position, {2.4, 0.1}), 0, 1e-13);
}

TEST(KeepClearance, PairsOnAMirrorAxisStayThereWhereTheyHaveRoom) {
  const Kept kept(two_holes(), points_at({{2.3, 0}, {2.9, 0}}, 5), {{{second_hole}, 0.3}});
  EXPECT_NEAR(distance(kept[0], {2.55, 0}), 0, 1e-7);
  EXPECT_EQ(kept[1], (Vec2{2.9, 0}));
}

/// lambda of the half sphere of radius 1 over the unit disc: its rim is pi / 2 - 2 atan(r) from a point.
double sphere_scale(Vec2 x, Vec2& gradient) {
  gradient = -2 / (1 + norm2(x)) * x;
  return std::log(2 / (1 + norm2(x)));
}

/// lambda of a surface that narrows inwards: its rim is (1 - r^3) / 3 from a point.
double narrow_scale(Vec2 x, Vec2& gradient) {
  gradient = 2 / norm2(x) * x;
  return std::log(norm2(x));
}

TEST(KeepClearance, OnACurvedFaceItIsALengthInSpace) {
  const CriticalPoints start = points_at({0.95 * unit(0.3), 0.4 * unit(2)});
  const Kept on_sphere(disc(), start, {{{0}, 0.2}}, {}, sphere_scale);
  EXPECT_NEAR(distance(on_sphere[0], std::tan(pi / 4 - 0.1) * unit(0.3)), 0, 1e-7);
  const Kept on_narrow(disc(), start, {{{0}, 0.2}}, {}, narrow_scale);
  EXPECT_NEAR(distance(on_narrow[0], std::cbrt(0.4) * unit(0.3)), 0, 1e-7);
  for (const Kept& kept : {on_sphere, on_narrow}) {
    EXPECT_EQ(kept[1], 0.4 * unit(2)) << "it has its clearance";
    EXPECT_TRUE(kept.report.warnings().empty());
  }
}

TEST(KeepClearance, OnACurvedFaceTheWarningHasLengthsInSpace) {
  const Kept kept(disc(), points_at({0.9 * unit(0.3)}), {{{0}, 2}}, {}, sphere_scale);
  ASSERT_EQ(kept.report.warnings().size(), 1u);
  EXPECT_NE(kept.report.warnings()[0].message.find("is 1.57 from"), std::string::npos)
      << kept.report.warnings()[0].message;
}

TEST(KeepClearance, AWallAllAroundIsMissedFromAllSides) {
  const Kept kept(disc(), points_at({{0.1, 0.05}}), {{{0}, 1.5}});
  EXPECT_LE(norm(kept[0]), 0.12);
  EXPECT_EQ(kept.report.warnings().size(), 1u);
}

}  // namespace
}  // namespace quadrille::placement
