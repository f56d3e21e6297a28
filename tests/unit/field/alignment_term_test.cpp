#include "field/alignment_term.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"
#include "base/error.hpp"

namespace quadrille::field {
namespace {

/// cos and sin of four times the angle.
Vec2 cross_of(double angle) { return unit(4 * angle); }

AlignmentRequest along(std::vector<Vec2> points, double width = 0.1) {
  AlignmentRequest request;
  request.features.push_back({std::move(points), {}, width, 1});
  return request;
}

AlignmentRequest in_box(double angle) {
  AlignmentRequest request;
  request.boxes.push_back({{0, 0}, {2, 1}, angle, 0.1, 1});
  return request;
}

TEST(AlignmentTerm, ACurvePullsWithOneOverItsWidthSquared) {
  const Alignment alignment = make_alignment(along({{0, 0}, {3, 4}}), 1, 5);
  const AlignmentTerm term(alignment);
  const double angle = std::atan2(4, 3);
  const auto middle = term.at({1.5, 2});
  EXPECT_NEAR(middle.rate, 100, 1e-9);
  EXPECT_NEAR(distance(middle.target, 100 * cross_of(angle)), 0, 1e-9);
  // exp(-1) at the distance of one width
  EXPECT_NEAR(term.at(Vec2{1.5, 2} + 0.1 * left_of(unit(angle))).rate, 100 * std::exp(-1), 1e-9);
  EXPECT_NEAR(term.at({0, 0}).rate, 50, 0.1) << "half of it at its end";
  EXPECT_EQ(term.at({3, 0}).rate, 0);
  EXPECT_TRUE(term.acts_in({3, 0}, 2));
  EXPECT_FALSE(term.acts_in({3, 0}, 1));
}

TEST(AlignmentTerm, TheDirectionOfTravelDoesNotMatter) {
  const std::vector<Vec2> points{{0, 0}, {1, 0.2}, {1.5, 1}, {1.2, 2}};
  const Alignment forth = make_alignment(along(points), 2, 3);
  const Alignment back = make_alignment(along({points.rbegin(), points.rend()}), 2, 3);
  const AlignmentTerm first(forth), second(back);
  for (const Vec2 x : {Vec2{0.5, 0.1}, Vec2{1, 0.25}, Vec2{1.45, 1.1}}) {
    EXPECT_NEAR(first.at(x).rate, second.at(x).rate, 1e-9 * first.at(x).rate);
    EXPECT_NEAR(distance(first.at(x).target, second.at(x).target), 0, 1e-9 * first.at(x).rate);
    EXPECT_LE(norm(first.at(x).target), first.at(x).rate);
  }
}

TEST(AlignmentTerm, ABoxHasOneDirection) {
  const Alignment alignment = make_alignment(in_box(0.3), 3, 3);
  const AlignmentTerm term(alignment);
  EXPECT_NEAR(term.at({1, 0.5}).rate, 900, 1e-6);
  EXPECT_NEAR(distance(term.at({1, 0.5}).target, 900 * cross_of(0.3)), 0, 1e-6);
  EXPECT_NEAR(term.at({0, 0.5}).rate, 450, 1e-6) << "half of it at a side";
}

TEST(AlignmentTerm, APointHasADirection) {
  AlignmentRequest request;
  request.features.push_back({{{1, 2}}, 0.2, 0.5, 3});
  const Alignment alignment = make_alignment(request, 2, 10);
  EXPECT_EQ(alignment, (Alignment{{{1, 2}, 0.5, 144, 0.2}}));
}

/// Lengths in the ratio 3 in the direction 0.4 or 0.4 and a right angle, at the points of a grid.
std::vector<MetricSample> sheared(bool is_across) {
  std::vector<MetricSample> samples;
  for (int i = 0; i <= 40; ++i)
    for (int j = 0; j <= 40; ++j) {
      const double angle = is_across ? 0.4 + half_pi : 0.4;
      samples.push_back({{i / 40.0, j / 40.0}, is_across ? 0.3 : 0.1, is_across ? 0.1 : 0.3, angle});
    }
  return samples;
}

TEST(AlignmentTerm, AMetricAlignsWithItsLengths) {
  for (const bool is_across : {false, true}) {
    AlignmentRequest request;
    request.metric = sheared(is_across);
    const Alignment alignment = make_alignment(request, 1, 1.4);
    const AlignmentTerm term(alignment);
    const double width = alignment.front().width, rate = 1 / (width * width) / 4;  // ((3 - 1) / (3 + 1))^2
    EXPECT_NEAR(width, 2.0 / 41, 1e-12) << "the length of two samples";
    const auto middle = term.at({0.5, 0.5});
    EXPECT_NEAR(middle.rate, rate, 1e-6 * rate);
    EXPECT_NEAR(distance(middle.target, rate * cross_of(0.4)), 0, 1e-6 * rate);
  }
}

TEST(AlignmentTerm, AMetricOfOneLengthAlignsNothing) {
  AlignmentRequest request;
  request.metric = sheared(false);
  for (MetricSample& sample : request.metric) sample.h1 = sample.h2;
  EXPECT_TRUE(make_alignment(request, 1, 1.4).empty());
}

TEST(AlignmentTerm, WithoutStrengthThereIsNone) {
  EXPECT_TRUE(make_alignment(along({{0, 0}, {1, 0}}), 0, 1).empty());
  EXPECT_TRUE(make_alignment(in_box(0), 0, 1).empty());
}

TEST(AlignmentTerm, FeaturesThatAreTooNarrowAreRefused) {
  EXPECT_THROW(make_alignment(along({{0, 0}, {1, 0}}, 1e-7), 1, 1), FormatError);
}

}  // namespace
}  // namespace quadrille::field
