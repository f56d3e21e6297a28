#include "placement/axis_pairs.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "node_samples.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

/// A box of 8 x 4 with a hole of radius 1 in its middle.
CadFace box() { return make_face({polygon({{-4, -2}, {4, -2}, {4, 2}, {-4, 2}}), hole({0, 0}, 1)}); }

std::vector<CriticalPoints> turned(const CadFace& face, const CriticalPoints& points, std::vector<bool> is_stuck = {}) {
  const std::vector<bool> may_move(points.critical_points.size(), true);
  is_stuck.resize(may_move.size(), is_stuck.empty());
  return with_turned_pairs(curve::FaceBoundary(face), node_symmetries(face, points, may_move), may_move, is_stuck,
                           points);
}

TEST(AxisPairs, AreTurnedAboutTheirMiddle) {
  const auto found = turned(box(), points_at({{1.5, 0}, {2.1, 0}, {3, 1}, {3, -1}}, 5), {false, true, false, false});
  ASSERT_EQ(found.size(), 1u);
  EXPECT_NEAR(distance(found[0].critical_points[0].position, {1.8, 0.3}), 0, 1e-15);
  EXPECT_NEAR(distance(found[0].critical_points[1].position, {1.8, -0.3}), 0, 1e-15);
  EXPECT_EQ(found[0].critical_points[2].position, (Vec2{3, 1})) << "no axis";
}

TEST(AxisPairs, AreTurnedWithTheirImages) {
  const CriticalPoints points = points_at({{1.5, 0}, {-1.5, 0}, {2.1, 0}, {-2.1, 0}}, 5);
  const auto found = turned(box(), points);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(node_symmetries(box(), found[0], {true, true, true, true}).size(), 4u);
  for (const CriticalPoint& node : found[0].critical_points) {
    EXPECT_NEAR(std::abs(node.position.x), 1.8, 1e-15);
    EXPECT_NEAR(std::abs(node.position.y), 0.3, 1e-15);
  }
}

TEST(AxisPairs, AreEqualFreeAndNearestToEachOther) {
  CriticalPoints unequal = points_at({{1.5, 0}, {2.1, 0}}, 5);
  unequal.critical_points[1].valence = 3;
  EXPECT_TRUE(turned(box(), unequal).empty());
  EXPECT_TRUE(turned(box(), points_at({{1.5, 0}, {2.1, 0}}), {false, false}).empty()) << "none is stuck";
  EXPECT_TRUE(turned(box(), points_at({{1.5, 0.1}, {2.1, 0.1}})).empty()) << "no axis";
  EXPECT_EQ(turned(box(), points_at({{1.5, 0}, {2.1, 0}, {2.8, 0}})).size(), 1u);
  EXPECT_TRUE(turned(box(), points_at({{1.5, 0}, {2.1, 0}, {2.7, 0}})).empty()) << "three at equal distances";
}

TEST(AxisPairs, StayWhereTheTurnLeadsOutOfTheFace) {
  EXPECT_TRUE(turned(box(), points_at({{-1.2, 0}, {1.2, 0}})).empty()) << "on both sides of the hole";
  EXPECT_TRUE(turned(box(), points_at({{0, 1.1}, {0, 1.9}, {0, -1.5}})).size() == 1u);
  const CadFace channel = make_face({polygon({{0, 0}, {4, 0}, {4, 1}, {0, 1}})});
  EXPECT_TRUE(turned(channel, points_at({{0.5, 0.5}, {1.6, 0.5}})).empty());
}

}  // namespace
}  // namespace quadrille::placement
