#include "trace/merged_curve.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace quadrille::trace
