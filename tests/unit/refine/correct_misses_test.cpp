#include "refine/correct_misses.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "chord_samples.hpp"
#include "refine/settle_counts.hpp"

namespace quadrille::refine {
namespace {

ChordDivision settled(const ChordSample& sample) {
  ChordDivision division = begin_division(sample.task);
  settle_counts(sample.task, division);
  return division;
}

TEST(CorrectMisses, NothingIsCorrectedWithinTheTolerance) {
  const ChordSample sample(hand_made::elbow(), 0, 3, {4, 10});
  ChordDivision division = settled(sample);
  EXPECT_FALSE(find_corrections(sample.task, division, 0).is_needed);
  EXPECT_FALSE(correct_misses(sample.task, division));
  EXPECT_TRUE(division.anchored.required.empty());
}

TEST(CorrectMisses, AnIntervalWithABreakEndsThere) {
  const ChordSample sample(hand_made::elbow(), 0, 1, {4, 1e-5});
  ChordDivision division = settled(sample);
  const Corrections corrections = find_corrections(sample.task, division, 0);
  EXPECT_TRUE(corrections.is_needed);
  EXPECT_EQ(corrections.anchors.size(), 1u);
  EXPECT_EQ(corrections.worst_errors, (std::vector<double>{0})) << "the break is tried before a higher count";
  EXPECT_TRUE(correct_misses(sample.task, division));
  EXPECT_FALSE(division.anchored.required.empty());
}

// Counts are those of segments before a cut: raised with it, they would go to one of the new segments, at one end.
TEST(CorrectMisses, CountsAreNotRaisedInTheRoundThatCutsASegment) {
  const ChordSample sample(hand_made::elbow(), 0, 3, {1, 1e-5});
  ChordDivision division = settled(sample);
  double worst = 0;
  bool is_cut = false;
  for (int i = 0; i < sample.task.num_arcs(); ++i) {
    const Corrections corrections = find_corrections(sample.task, division, i);
    for (const double error : corrections.worst_errors) worst = std::max(worst, error);
    is_cut |= !corrections.anchors.empty();
  }
  ASSERT_TRUE(is_cut);
  ASSERT_GT(worst, sample.options.tolerance);
  EXPECT_TRUE(correct_misses(sample.task, division));
  for (const int least : division.anchored.segments.least_counts) EXPECT_EQ(least, 1);
}

TEST(CorrectMisses, ASmoothIntervalOfEqualElementsRaisesTheCountOfItsSegment) {
  const ChordSample sample(hand_made::quarter_annulus(), 1, 2, {2, 1e-5});
  ChordDivision division = settled(sample);
  const Corrections corrections = find_corrections(sample.task, division, 0);
  EXPECT_TRUE(corrections.anchors.empty());
  EXPECT_TRUE(corrections.constraints.empty());
  ASSERT_EQ(corrections.worst_errors.size(), 1u);
  EXPECT_GT(corrections.worst_errors[0], sample.options.tolerance);
  EXPECT_TRUE(correct_misses(sample.task, division));
  EXPECT_GT(division.anchored.segments.least_counts[0], 2);
  EXPECT_LE(division.anchored.segments.least_counts[0], 8) << "at most four in place of one";
}

TEST(CorrectMisses, AnIntervalOfAGradedChordAloneBecomesShorter) {
  ChordSample sample(hand_made::quarter_annulus(), 1, 4, {2, 1e-5});
  sample.plan.grading = sizing::Grading({0, 1}, {0.02, 0.6});
  sample.plan.slope = 1;
  ChordDivision division = settled(sample);
  const Corrections corrections = find_corrections(sample.task, division, 0);
  EXPECT_TRUE(corrections.anchors.empty());
  for (const double error : corrections.worst_errors) EXPECT_EQ(error, 0);
  ASSERT_FALSE(corrections.constraints.empty());
  for (const sizing::MaxLengthConstraint& c : corrections.constraints) {
    EXPECT_GE(c.reduction, 1.05);
    EXPECT_NEAR(c.max_length, (c.high - c.low) / c.reduction, 1e-12);
  }
  const double first = division.grading.parameter(0.25), before = division.planned_count;
  EXPECT_TRUE(correct_misses(sample.task, division));
  EXPECT_GT(division.planned_count, before);
  EXPECT_GT(division.least_count, division.count() - 1);
  EXPECT_LE(division.grading.parameter(0.25), first * 4) << "the short elements stay short";
}

TEST(CorrectMisses, ManyBreaksThatAreSpreadAreNoEndsBeforeTheIntervalIsShort) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int k = 0; k <= 20; ++k) {
    const double x = k / 20.0;
    parameters.push_back(x);
    points.push_back({x, 0.05 * std::sin(2 * pi * x)});
  }
  const Vec2 slope{1, 0.1 * pi};
  const std::vector<Nurbs> loop{curve::cubic_spline(parameters, points, slope, slope), curve::segment({1, 0}, {1, 1}),
                                curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  const ChordSample sample(hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}}), 0, 1,
                           {2, 1e-4});
  const ChordDivision division = settled(sample);
  ASSERT_GT(division.anchored.anchors.size(), 2u);
  const Corrections corrections = find_corrections(sample.task, division, 0);
  EXPECT_TRUE(corrections.anchors.empty());
  EXPECT_GT(corrections.worst_errors[0], 0);
}

// The unit square, its lower side through these points, which must turn by less than a corner. The last piece is curved
// if asked for.
Corrections corrections_of_lower_side(const std::vector<Vec2>& points, bool is_curved = false) {
  std::vector<Nurbs> loop;
  std::vector<std::vector<int>> sides(1);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    sides[0].push_back(static_cast<int>(i));
    loop.push_back(curve::segment(points[i], points[i + 1]));
  }
  if (is_curved)
    loop.back() = {3, {0, 0, 0, 0, 1, 1, 1, 1}, {points.end()[-2], {0.4, 0.001}, {0.8, 0.2}, {1, 0}}, {1, 1, 1, 1}};
  for (const auto& [from, to] : {std::pair<Vec2, Vec2>{{1, 0}, {1, 1}}, {{1, 1}, {0, 1}}, {{0, 1}, {0, 0}}}) {
    sides.push_back({static_cast<int>(loop.size())});
    loop.push_back(curve::segment(from, to));
  }
  CadFace face = hand_made::face({loop}, std::sqrt(2.0));
  for (int i = 0; i < face.num_curves(); ++i) face.unnamed_curves.push_back(i);
  const ChordSample sample(hand_made::one_block(std::move(face), sides), 0, 1, {2, 1e-5});
  return find_corrections(sample.task, settled(sample), 0);
}

TEST(CorrectMisses, OfBreaksThatNearlyCoincideOneIsAnEnd) {
  EXPECT_EQ(corrections_of_lower_side({{0, 0}, {0.4, 0.004}, {0.4001, 0.004}, {1, 0}}).anchors, (std::vector<int>{1}))
      << "the nearer to the middle";
  EXPECT_EQ(corrections_of_lower_side({{0, 0}, {0.3, 0.004}, {0.7, 0.004}, {1, 0}}).anchors.size(), 2u);
}

TEST(CorrectMisses, ABreakNearAnEndIsAnEndOnlyIfTheRestMeetsTheTolerance) {
  const std::vector<Vec2> bent{{0, 0}, {0.01, 0.0001}, {1, 0}};
  EXPECT_EQ(corrections_of_lower_side(bent).anchors, (std::vector<int>{0}));
  const Corrections curved = corrections_of_lower_side(bent, true);
  EXPECT_TRUE(curved.anchors.empty());
  EXPECT_GT(curved.worst_errors[0], 0) << "more elements first";
}

}  // namespace
}  // namespace quadrille::refine
