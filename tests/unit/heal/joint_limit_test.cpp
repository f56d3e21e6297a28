#include "heal/joint_limit.hpp"

#include <gtest/gtest.h>

#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

// The limits at the corner (4, 0) of a polygon.
LimitedJoint limited(const std::vector<Vec2>& polygon, double tolerance) {
  const RawFace raw = raw_polygon(polygon);
  const auto wires = measured(raw.wires);
  const JointLimit limit(raw.wires, tolerance);
  const auto& w = wires[0];
  return limit.joint(w[0], w[1], {w.back().raw, w[0].raw, w[1].raw, w[2].raw});
}

TEST(JointLimit, IsTheTolerance) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.01);
  EXPECT_DOUBLE_EQ(joint.in.most, 0.01);
  EXPECT_DOUBLE_EQ(joint.out.most, 0.01);
  EXPECT_EQ(joint.reason, LimitReason::tolerance);
}

TEST(JointLimit, LinesWhoseEndsAreNearSlideFourTolerances) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {0, 4}}, 0.01);
  EXPECT_DOUBLE_EQ(joint.in.most_sliding, 0.04);
  EXPECT_DOUBLE_EQ(joint.out.most_sliding, 0.04);
  EXPECT_DOUBLE_EQ(limited({{0, 0}, {4, 0}, {4, 0.1}, {0, 4}}, 0.01).out.most_sliding, 0.025)
      << "a quarter of the line";
}

TEST(JointLimit, IsATenthOfEachEdge) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 2}, {0, 4}}, 1);
  EXPECT_DOUBLE_EQ(joint.in.most, 0.4);
  EXPECT_DOUBLE_EQ(joint.out.most, 0.2);
  EXPECT_EQ(joint.reason, LimitReason::edge);
}

TEST(JointLimit, IsAQuarterOfTheDistanceToOtherEdges) {
  const LimitedJoint joint = limited({{0, 0}, {4, 0}, {4, 4}, {5, 4}, {5, -1}, {4.4, -1}, {4.4, 0.3}, {4.1, 0}}, 1);
  EXPECT_NEAR(joint.in.most, 0.1 / 4, 1e-12);
  EXPECT_EQ(joint.reason, LimitReason::clearance);
}

}  // namespace
}  // namespace quadrille::heal
