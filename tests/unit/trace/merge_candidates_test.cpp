#include "trace/merge_candidates.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/two_nodes.hpp"

namespace quadrille::trace {
namespace {

TEST_F(TwoNodes, ExactlyHeadOnLinesMergeIntoOneStraightLine) {
  make(0);
  const auto found = candidates(5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].deviation, 1e-6);
  EXPECT_LT(found[0].gap, 1e-6);
  EXPECT_NEAR(found[0].length(), 1, 1e-6);
  const curve::CurveFunction merged = merged_curve(*evaluator, lines[found[0].a], lines[found[0].b], found[0]);
  for (int i = 0; i <= 10; ++i) {
    Vec2 d;
    EXPECT_LT(distance(merged(found[0].length() * i / 10, d), {-0.5 + i / 10.0, 0}), 1e-6);
  }
}

TEST_F(TwoNodes, MergingKeepsEndsAndEndDirections) {
  make(0.2);
  const auto found = candidates(20);
  ASSERT_EQ(found.size(), 1u);
  const Streamline &a = lines[found[0].a], &b = lines[found[0].b];
  const curve::CurveFunction merged = merged_curve(*evaluator, a, b, found[0]);
  Vec2 start, end;
  EXPECT_EQ(merged(0, start), nodes[0]);
  EXPECT_EQ(merged(found[0].length(), end), nodes[1]);
  EXPECT_LT(distance(normalized(start), unit(a.launch.angle)), 1e-12);
  EXPECT_LT(distance(normalized(end), -unit(b.launch.angle)), 1e-12);
  // The mirror image in the centre exchanges both lines: the merged line passes through it.
  Vec2 d;
  EXPECT_LT(norm(merged(found[0].length() / 2, d)), 1e-9);
}

TEST_F(TwoNodes, TheDerivativeIsThatOfTheCurve) {
  make(0.2);
  const auto found = candidates(20);
  ASSERT_EQ(found.size(), 1u);
  const curve::CurveFunction merged = merged_curve(*evaluator, lines[found[0].a], lines[found[0].b], found[0]);
  for (const double s : {0.2, 0.5, 0.7}) {
    Vec2 d, unused;
    merged(s, d);
    EXPECT_LT(distance((merged(s + 1e-5, unused) - merged(s - 1e-5, unused)) / 2e-5, d), 1e-5);
  }
}

TEST_F(TwoNodes, ALineThatEndsInANodeTakesThePlaceOfTheOneThatComesItsWay) {
  make(0.2);
  EXPECT_TRUE(candidates(1).empty());
  // The line that leaves the first node towards the second is taken to end in it.
  const auto towards = std::min_element(lines.begin(), lines.begin() + 3, [](const auto& a, const auto& b) {
    return std::cos(a.launch.angle) > std::cos(b.launch.angle);
  });
  *towards = advance(*evaluator, towards->launch, PointGrid(nodes), {1e-11, 0.1, 10, 0.1});
  ASSERT_EQ(towards->reached.node, 1);
  const auto found = candidates(1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_join);
  EXPECT_EQ(found[0].a, towards - lines.begin());
  EXPECT_EQ(lines[found[0].b].launch.start.node, 1);
  Vec2 d;
  EXPECT_EQ(merged_curve(*evaluator, lines[found[0].a], lines[found[0].b], found[0])(found[0].length(), d), nodes[1]);
}

TEST_F(TwoNodes, TheAngleDecidesAndTheDistanceOverrides) {
  make(0.2);
  const auto all = candidates(20);
  ASSERT_EQ(all.size(), 1u);
  const double deviation = degrees(all[0].deviation);
  EXPECT_GT(deviation, 1);
  EXPECT_TRUE(candidates(0.9 * deviation).empty());
  EXPECT_EQ(candidates(1.1 * deviation).size(), 1u);
  EXPECT_TRUE(candidates(0, 0.9 * all[0].gap).empty());
  EXPECT_EQ(candidates(0, 1.1 * all[0].gap).size(), 1u);
}

// Lines of the second node that were not followed as far as the first: nothing that could merge.
struct ShortOfOneNode : TwoNodes {
  void make(double skew) {
    TwoNodes::make(skew);
    for (size_t i = 3; i < lines.size(); ++i)
      lines[i] = advance(*evaluator, lines[i].launch, PointGrid(nodes), {1e-11, 0.1, 0.3, 1e-7});
  }
};

TEST_F(ShortOfOneNode, ALineThatPassesWithinTheDistanceIsJoined) {
  make(0.2);
  EXPECT_TRUE(candidates(20).empty());
  const auto found = candidates(0, 0.5);
  ASSERT_EQ(found.size(), 1u);
  const MergeCandidate& join = found[0];
  EXPECT_TRUE(join.is_join);
  EXPECT_LT(join.a, 3);
  EXPECT_GE(join.b, 3);
  EXPECT_GT(join.deviation, radians(1));
  EXPECT_LT(join.deviation, merge_limits.aggressive_angle);
  EXPECT_TRUE(candidates(0, 0.99 * join.gap).empty());
  EXPECT_EQ(candidates(0, 1.01 * join.gap).size(), 1u);
  const Streamline &a = lines[join.a], &b = lines[join.b];
  const curve::CurveFunction curve = merged_curve(*evaluator, a, b, join);
  Vec2 start, end, d, unused;
  EXPECT_EQ(curve(0, start), nodes[0]);
  EXPECT_EQ(curve(join.length(), end), nodes[1]);
  EXPECT_LT(distance(normalized(start), unit(a.launch.angle)), 1e-12);
  EXPECT_LT(distance(normalized(end), -unit(b.launch.angle)), 1e-12);
  for (const double s : {0.2, 0.5, 0.7}) {
    curve(s, d);
    EXPECT_LT(distance((curve(s + 1e-5, unused) - curve(s - 1e-5, unused)) / 2e-5, d), 1e-5);
  }
}

TEST_F(TwoNodes, APairThatMergesIsNotJoinedAsWell) {
  make(0.2);
  const auto found = candidates(0, 0.5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_FALSE(found[0].is_join);
}

}  // namespace
}  // namespace quadrille::trace
