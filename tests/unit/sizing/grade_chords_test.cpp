#include "sizing/grade_chords.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::sizing {
namespace {

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

ElementDensity density(const MeasuredLayout& measured, int chord, const SizeField& sizes, double u) {
  return ChordSections(measured, measured.chords()[chord], chord_blocks(measured)[chord], sizes).at(u);
}

TEST(ChordSections, EveryBlockLiesOnTwoChords) {
  const BlockLayout layout = layout_of(hand_made::l_shape());
  const MeasuredLayout measured(layout);
  std::vector<int> count(layout.num_blocks(), 0);
  for (const std::vector<ChordBlock>& blocks : chord_blocks(measured))
    for (const ChordBlock& b : blocks) ++count[b.block];
  EXPECT_EQ(count, (std::vector<int>{2, 2, 2}));
}

TEST(ChordSections, OneSizeIsAveragedOverTheLengthOfTheArcs) {
  // Arcs of length pi and pi / 2: the mean of the logarithms, weighted by length.
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  const MeasuredLayout measured(layout);
  const ElementDensity d = density(measured, 1, SizeField(0.1), 0.3);
  EXPECT_NEAR(d.nearest, 10 * pi / std::cbrt(2.0), 1e-9);
  EXPECT_NEAR(d.greatest, 10 * pi, 1e-9);
}

TEST(ChordSections, AFineSizeOnOneArcWinsByTheSixthPower) {
  // Lines of length 1 with sizes from 0.05 at x = 0 to 0.05 + ln(1.2) at x = 1: two arcs, and lines between them.
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(1, {}, {{{0, -1}, {0, 2}, 0.05, 0.05}}, 1.2);
  const int chord = measured.chord_of(3);
  const ElementDensity d = density(measured, chord, sizes, 0.5);
  EXPECT_NEAR(d.greatest, 1 / 0.05, 1e-9) << "on the arc at x = 0";
  EXPECT_LT(d.nearest, d.greatest);
  EXPECT_GT(d.nearest, 0.8 * d.greatest);
}

TEST(ChordSections, ASourceInsideABlockIsSeenThere) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(0.5, {{{{0.5, 0.5}, 0.01, 0}}, {}, 0}, {}, 1.2);
  for (const int chord : {0, 1}) {
    EXPECT_GT(density(measured, chord, sizes, 0.5).greatest, 50);
    EXPECT_LT(density(measured, chord, sizes, 0.02).greatest, 15) << "far from the source";
  }
}

TEST(ChordSections, MirroredParametersOfASymmetricChordAgree) {
  const BlockLayout layout = layout_of(hand_made::unit_square());
  const MeasuredLayout measured(layout);
  const SizeField sizes(0.5, {{{{0.5, 0.5}, 0.02, 0.1}}, {}, 0}, {}, 1.3);
  for (const double u : {0.0, 0.1, 0.37}) {
    const ElementDensity low = density(measured, 0, sizes, u), high = density(measured, 0, sizes, 1 - u);
    EXPECT_NEAR(low.nearest, high.nearest, 1e-9 * low.nearest);
    EXPECT_NEAR(low.greatest, high.greatest, 1e-9 * low.greatest);
  }
}

std::vector<ChordPlan> plans(const SeparatrixGraph& graph, const SizeField& sizes, SizeRule rule = SizeRule::nearest,
                             const std::vector<ChordCount>& counts = {}) {
  Report report;
  const BlockLayout layout = block::extract_blocks(graph, report);
  return grade_chords(MeasuredLayout(layout), sizes, rule, counts);
}

TEST(GradeChords, WholeCountsAreNearestByTheLogarithm) {
  for (const auto& [wanted, count] : {std::pair{0.2, 1.0}, {1.41, 1.0}, {1.42, 2.0}, {10.48, 10.0}, {10.49, 11.0}})
    EXPECT_EQ(whole_count(wanted, SizeRule::nearest), count) << wanted;
  for (const auto& [wanted, count] : {std::pair{0.2, 1.0}, {1.01, 2.0}, {10.0, 10.0}, {10.1, 11.0}})
    EXPECT_EQ(whole_count(wanted, SizeRule::at_most), count) << wanted;
}

TEST(GradeChords, MirrorImagesAgreeWhereRoundingWouldNot) {
  const double tie = std::sqrt(6.0 * 7.0);
  EXPECT_EQ(whole_count(tie * (1 - 1e-9), SizeRule::nearest), whole_count(tie * (1 + 1e-9), SizeRule::nearest));
  EXPECT_EQ(whole_count(7 - 1e-9, SizeRule::at_most), whole_count(7 + 1e-9, SizeRule::at_most));
}

TEST(GradeChords, OneSizeForAllDeviatesLeastOverTheLength) {
  // Arcs of length pi and pi / 2: the mean of the logarithms, weighted by length, is that of pi / 2^(1/3).
  const std::vector<ChordPlan> p = plans(hand_made::quarter_annulus(), SizeField(0.1));
  EXPECT_TRUE(p[1].grading.is_identity());
  EXPECT_NEAR(p[1].grading.count(), 10 * pi / std::cbrt(2.0), 1e-10);
  EXPECT_EQ(p[0].count, 10);
  const std::vector<ChordPlan> q = plans(hand_made::quarter_annulus(), SizeField(0.1), SizeRule::at_most);
  EXPECT_EQ(q[1].count, 32);
}

TEST(GradeChords, ElementsFollowASizeThatVariesAlongTheChordOnly) {
  // A size that grows from the side x = 0 of the unit square: eta = 0.02 + ln(1.2) u.
  const double slope = std::log(1.2);
  const SizeField sizes(10, {}, {{{0, -1}, {0, 2}, 0.02, 0.02}}, 1.2);
  const std::vector<ChordPlan> p = plans(hand_made::unit_square(), sizes);
  const double count = std::log(1 + slope / 0.02) / slope;
  EXPECT_NEAR(p[0].grading.count(), count, 1e-9);
  for (const double v : {0.1, 0.5, 0.9})
    EXPECT_NEAR(p[0].grading.parameter(v), 0.02 * std::expm1(slope * v * count) / slope, 1e-9);
  EXPECT_FALSE(p[0].is_prescribed);
}

TEST(GradeChords, ASizeAskedForInOnePlaceIsMetThere) {
  // Across the chord that follows x = 0 the wanted lengths go from 0.02 to 0.2, but 0.02 counts far more.
  const SizeField sizes(1, {}, {{{0, -1}, {0, 2}, 0.02, 0.02}}, 1.2);
  const double count = plans(hand_made::unit_square(), sizes)[1].grading.count();
  EXPECT_GT(count, 0.85 / 0.02);
  EXPECT_LE(count, 1 / 0.02 * (1 + 1e-9));
  EXPECT_NEAR(plans(hand_made::unit_square(), sizes, SizeRule::at_most)[1].grading.count(), 1 / 0.02, 1e-9);
}

TEST(GradeChords, SourcesInsideABlockAreSeen) {
  const SizeField sizes(0.5, {{{{0.5, 0.5}, 0.01, 0}}, {}, 0}, {}, 1.2);
  for (const ChordPlan& plan : plans(hand_made::unit_square(), sizes)) {
    EXPECT_GT(plan.count, 15);
    const Grading& g = plan.grading;
    const double middle = g.parameter(0.5 + 1 / g.count()) - g.parameter(0.5), end = g.parameter(1 / g.count());
    EXPECT_LT(middle, 0.02);
    EXPECT_GT(end, 0.06);
  }
}

TEST(GradeChords, NeighboursGrowByTheFactorAtMost) {
  const SizeField sizes(0.5, {{{{0.3, 0.4}, 0.005, 0}, {{0.9, 0.1}, 0.01, 0}}, {}, 0}, {}, 1.25);
  for (const SizeRule rule : {SizeRule::nearest, SizeRule::at_most})
    for (const ChordPlan& plan : plans(hand_made::unit_square(), sizes, rule)) {
      const double n = std::ceil(plan.grading.count());
      for (int k = 1; k < n; ++k) {
        const auto end = [&](int i) { return plan.grading.parameter(i / n); };
        const double ratio = (end(k + 1) - end(k)) / (end(k) - end(k - 1));
        EXPECT_LE(std::max(ratio, 1 / ratio), 1.25 * (1 + 1e-6));
      }
    }
}

TEST(GradeChords, CountsAskedForTakeThePlaceOfSizes) {
  const std::vector<ChordPlan> p = plans(hand_made::unit_square(), SizeField(0.1), SizeRule::nearest, {{1, 3}});
  EXPECT_EQ(p[0].count, 10);
  EXPECT_EQ(p[1].count, 3);
  EXPECT_TRUE(p[1].is_prescribed);
  EXPECT_THROW(plans(hand_made::unit_square(), SizeField(0.1), SizeRule::nearest, {{2, 3}}), UsageError);
  EXPECT_THROW(plans(hand_made::unit_square(), SizeField(0.1), SizeRule::nearest, {{-1, 3}}), UsageError);
}

/// h along x and y.
SizeField constant_metric(double along_x, double along_y) {
  SizeSources sources;
  sources.metric = {{{}, along_y, along_x, half_pi}};
  return {1, sources, {}, 1.2};
}

TEST(GradeChords, OfAConstantMetricTheSidesOfQuadsHaveTheRatioOfItsLengths) {
  for (const SizeRule rule : {SizeRule::nearest, SizeRule::at_most, SizeRule::error}) {
    const BlockLayout layout = layout_of(hand_made::unit_square());
    const MeasuredLayout measured(layout);
    const std::vector<ChordPlan> of = grade_chords(measured, constant_metric(0.2, 0.05), rule, {});
    for (int arc = 0; arc < measured.num_arcs(); ++arc) {
      const Vec2 step = measured.chain(arc).position(1) - measured.chain(arc).position(0);
      EXPECT_EQ(of[measured.chord_of(arc)].count, std::abs(step.x) > 0.5 ? 5 : 20);
    }
  }
}

TEST(ChordSections, OfAMetricTheLengthAlongTheArcCounts) {
  // Along a quarter of a circle from the x axis to the y axis.
  const BlockLayout layout = layout_of(hand_made::quarter_annulus());
  const MeasuredLayout measured(layout);
  const SizeField sizes = constant_metric(0.1, 0.2);
  for (const double u : {0.0, 0.3, 0.8}) {
    const ElementDensity d = density(measured, 1, sizes, u);
    const curve::ChainPoint on_arc =
        measured.chain(measured.chords()[1].arcs[0]).at(measured.arc_fraction(measured.chords()[1], 0, u));
    EXPECT_NEAR(d.greatest, pi * std::hypot(on_arc.tangent.x / 0.1, on_arc.tangent.y / 0.2), 1e-9);
  }
}

}  // namespace
}  // namespace quadrille::sizing
