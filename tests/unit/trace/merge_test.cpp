#include "trace/merge.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>

#include "../support/square_field.hpp"

namespace quadrille::trace {
namespace {

using Complex = std::complex<double>;

// v = -e^{i skew} (z^2 - 1/4): nodes of valence 3 at -1/2 and 1/2. Without skew two of their separatrices run into each
// other along the axis; with it they pass each other.
struct TwoNodes : testing::Test {
  void make(double skew) {
    const auto value = [skew](Vec2 p) {
      const Complex z(p.x, p.y), v = -std::polar(1.0, skew) * (z * z - 0.25);
      return Vec2{v.real(), v.imag()};
    };
    field = interpolated_field(square_mesh({-1, -1}, 2, 4), 2, value);
    evaluator = std::make_unique<field::FieldEvaluator>(field);
    lines.clear();
    for (int n = 0; n < 2; ++n) {
      const mesh::Location at = evaluator->locator().find(nodes[n]);
      for (const double angle : launch_directions(evaluator->sample(at.elem, at.xi).dv_dx))
        lines.push_back(
            advance(*evaluator, launch_line(*evaluator, n, nodes[n], angle, 1e-4, 1), nodes, {1e-11, 0.1, 10, 1e-7}));
    }
  }

  std::vector<MergeCandidate> candidates(double degrees_allowed, double distance_allowed = 0) const {
    return merge_candidates(*evaluator, lines, nodes, {radians(degrees_allowed), distance_allowed});
  }

  const std::vector<Vec2> nodes{{-0.5, 0}, {0.5, 0}};
  Field field;
  std::unique_ptr<field::FieldEvaluator> evaluator;
  std::vector<Streamline> lines;
};

TEST_F(TwoNodes, ExactlyHeadOnLinesMergeIntoOneStraightLine) {
  make(0);
  const auto found = candidates(5);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_LT(found[0].turn, 1e-6);
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

TEST_F(TwoNodes, ALineThatEndsInANodeTakesThePlaceOfTheOneThatComesItsWay) {
  make(0.2);
  EXPECT_TRUE(candidates(1).empty());
  // The line that leaves the first node towards the second is taken to end in it.
  const auto towards = std::min_element(lines.begin(), lines.begin() + 3, [](const auto& a, const auto& b) {
    return std::cos(a.launch.angle) > std::cos(b.launch.angle);
  });
  *towards = advance(*evaluator, towards->launch, nodes, {1e-11, 0.1, 10, 0.1});
  ASSERT_EQ(towards->end_node, 1);
  const auto found = candidates(1);
  ASSERT_EQ(found.size(), 1u);
  EXPECT_TRUE(found[0].is_join);
  EXPECT_EQ(found[0].a, towards - lines.begin());
  EXPECT_EQ(lines[found[0].b].launch.node, 1);
  Vec2 d;
  EXPECT_EQ(merged_curve(*evaluator, lines[found[0].a], lines[found[0].b], found[0])(found[0].length(), d), nodes[1]);
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

TEST_F(TwoNodes, TheAngleDecidesAndTheDistanceOverrides) {
  make(0.2);
  const auto all = candidates(20);
  ASSERT_EQ(all.size(), 1u);
  const double turn = degrees(all[0].turn);
  EXPECT_GT(turn, 1);
  EXPECT_TRUE(candidates(0.9 * turn).empty());
  EXPECT_EQ(candidates(1.1 * turn).size(), 1u);
  EXPECT_TRUE(candidates(0, 0.9 * all[0].gap).empty());
  EXPECT_EQ(candidates(0, 1.1 * all[0].gap).size(), 1u);
}

// Lines of the second node that were not followed as far as the first: nothing that could merge.
struct ShortOfOneNode : TwoNodes {
  void make(double skew) {
    TwoNodes::make(skew);
    for (size_t i = 3; i < lines.size(); ++i)
      lines[i] = advance(*evaluator, lines[i].launch, nodes, {1e-11, 0.1, 0.3, 1e-7});
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
  EXPECT_GT(join.turn, radians(1));
  EXPECT_LT(join.turn, greatest_aggressive_angle);
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

MergeCandidate pair(int a, int b, double length) { return {a, b, length, length, 0, 0}; }

std::vector<int> choose(const std::vector<MergeCandidate>& all, const std::vector<bool>& allowed) {
  std::vector<bool> taken(5, false);
  return choose_merges(all, allowed, taken);
}

TEST(ChooseMerges, TakesTheFirstMeetingOfALine) {
  const std::vector<MergeCandidate> all{pair(0, 1, 1), pair(1, 2, 2), pair(2, 3, 3)};
  EXPECT_EQ(choose(all, {true, true, true}), (std::vector<int>{0, 2}));
  EXPECT_EQ(choose(all, {false, true, true}), (std::vector<int>{1}));
}

TEST(ChooseMerges, DecidesTiesOfAnOrbitAlike) {
  // Line 0 could go either way at the same time: neither, and the later meeting of 1 and 2 is free.
  const std::vector<MergeCandidate> all{pair(0, 1, 1), pair(0, 2, 1 + 1e-9), pair(3, 4, 1 + 1e-9), pair(1, 2, 2)};
  EXPECT_EQ(choose(all, {true, true, true, true}), (std::vector<int>{2, 3}));
}

}  // namespace
}  // namespace quadrille::trace
