#include <gtest/gtest.h>

#include <limits>

#include "../samples.hpp"
#include "rules_of.hpp"

namespace quadrille {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  CriticalPoints points = samples::critical_points();
  damage(points);
  return rules_of(check_critical_points(points, CheckDepth::full));
}

TEST(CriticalPointsCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](CriticalPoints&) {}), Rules{});
}

TEST(CriticalPointsCheck, CrtR01NumbersAreFinite) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].position.x = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"CRT-R01"});
  EXPECT_EQ(broken([](auto& c) { c.corners[0].angle_degrees = std::numeric_limits<double>::infinity(); }),
            Rules{"CRT-R01"});
}
TEST(CriticalPointsCheck, CrtR02ValencesFitIndices) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].index = 2; }), Rules{"CRT-R02"});
}
TEST(CriticalPointsCheck, CrtR03ElementsAreSound) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].elem = -1; }), Rules{"CRT-R03"});
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].xi = {0.5, 0.5}; }), Rules{"CRT-R03"});
}
TEST(CriticalPointsCheck, CrtR04CornersAreSound) {
  EXPECT_EQ(broken([](auto& c) { c.corners[1].joint = 0; }), Rules{"CRT-R04"});
  EXPECT_EQ(broken([](auto& c) { c.corners[1].curves[0] = -1; }), Rules{"CRT-R04"});
  EXPECT_EQ(broken([](auto& c) { c.corners[1].angle_degrees = 360; }), Rules{"CRT-R04"});
}
TEST(CriticalPointsCheck, CrtR05IndexSumIsTheSum) {
  EXPECT_EQ(broken([](auto& c) { c.corners[2].valence = 2; }), Rules{"CRT-R05"});
}
TEST(CriticalPointsCheck, CrtR06IndexSumIsFourChi) {
  EXPECT_EQ(broken([](auto& c) { c.index_sum_expected = 0; }), Rules{"CRT-R06"});
  EXPECT_EQ(broken([](auto& c) {
              c.index_sum_expected = c.index_sum = 3;
              c.corners[2].valence = 2;
            }),
            Rules{"CRT-R06"});
}
TEST(CriticalPointsCheck, CrtR07JacobiansFitIndices) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[1].jacobian = {1, 0, 0, 1}; }), Rules{"CRT-R07"});
}
TEST(CriticalPointsCheck, CrtR08PointsDiffer) {
  EXPECT_EQ(broken([](auto& c) {
              c.critical_points[1].position = c.critical_points[0].position + Vec2{1e-12, 0};
            }),
            Rules{"CRT-R08"});
  EXPECT_EQ(broken([](auto& c) { c.critical_points[1].position = c.critical_points[0].position; }), Rules{"CRT-R08"});
}

template <typename Damage>
Rules broken_beside_field(const Damage& damage) {
  CriticalPoints points = samples::critical_points();
  damage(points);
  return rules_of(check_critical_points_of(points, samples::field()));
}

TEST(CriticalPointsCheck, TheSampleFitsItsField) {
  EXPECT_EQ(broken_beside_field([](CriticalPoints&) {}), Rules{});
}

TEST(CriticalPointsCheck, CrtR09ElementsExistInTheField) {
  EXPECT_EQ(broken_beside_field([](auto& c) { c.critical_points[0].elem = 4; }), Rules{"CRT-R09"});
}
TEST(CriticalPointsCheck, CrtR10CornersAreTheFaces) {
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners.pop_back(); }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners.push_back(c.corners[3]); }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].joint = 2; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].curves = {1, 0}; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].position.x += 0.1; }), Rules{"CRT-R10"});
  EXPECT_EQ(broken_beside_field([](auto& c) { c.corners[1].angle_degrees = 91; }), Rules{"CRT-R10"});
}
TEST(CriticalPointsCheck, CrtR11ErrorsAreNotNegative) {
  EXPECT_EQ(broken([](auto& c) { c.critical_points[0].error = -1e-9; }), Rules{"CRT-R11"});
}

}  // namespace
}  // namespace quadrille
