#include "growth/limit_growth.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "divided.hpp"

namespace quadrille::growth {
namespace {

TEST(RecountChord, BreaksRemainEndsAndAllArcsGetOneCount) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::elbow(), report);
  const sizing::MeasuredLayout measured(layout);
  const auto plans = sizing::grade_chords(measured, sizing::SizeField(0.3), sizing::SizeRule::nearest, {});
  sizing::ArcDivisions divisions = refine::divide_arcs(measured, plans, {4, 1e-6});
  const GrowthInput input{measured, 1.3, 4, 1e-6};
  for (int chord = 0; chord < static_cast<int>(measured.chords().size()); ++chord) {
    const std::vector<int>& arcs = measured.chords()[chord].arcs;
    const int before = divisions[arcs[0]].num_intervals();
    std::vector<std::vector<double>> kept;  // by arc: breaks at which intervals end
    for (const int arc : arcs) {
      kept.emplace_back();
      for (const double f : fixed_fractions(input, arc))
        for (const double end : divisions[arc].ends)
          if (std::abs(f - end) < 1e-9) kept.back().push_back(end);
    }
    const int count = recount_chord(input, chord, before + 3, divisions);
    EXPECT_GE(count, before + 3);
    for (std::size_t i = 0; i < arcs.size(); ++i) {
      const std::vector<double>& ends = divisions[arcs[i]].ends;
      EXPECT_EQ(static_cast<int>(ends.size()), count + 1);
      EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
      for (const double f : kept[i]) EXPECT_EQ(std::count(ends.begin(), ends.end(), f), 1);
    }
  }
}

void expect_within(const Divided& d, double limit) {
  for (const IntervalPair& pair : adjacent_intervals(d.input(), d.divisions))
    EXPECT_LE(std::abs(log_growth(d.input(), d.divisions, pair)), std::log(limit) * (1 + 1e-5));
}

TEST(LimitGrowth, DivisionsWithinTheLimitKeepTheirCounts) {
  Divided d(hand_made::row({1, 1}), 0.1);
  const sizing::ArcDivisions before = d.divisions;
  const GrowthOutcome outcome = limit_growth(d.input(), d.divisions);
  EXPECT_EQ(outcome.raised_chords, 0);
  EXPECT_NEAR(outcome.worst, 1, 1e-9);
  for (std::size_t arc = 0; arc < before.size(); ++arc)
    for (std::size_t k = 0; k < before[arc].ends.size(); ++k)
      EXPECT_NEAR(d.divisions[arc].ends[k], before[arc].ends[k], 1e-9);
}

TEST(LimitGrowth, EndsMoveSoThatIntervalsBecomeSimilarAcrossANode) {
  Divided d(hand_made::row({1, 1}), 0.1, {20, 10});
  const GrowthOutcome outcome = limit_growth(d.input(), d.divisions);
  EXPECT_NEAR(outcome.worst_before, 2, 1e-9);
  EXPECT_LE(outcome.worst, 1.3);
  EXPECT_EQ(d.count(0), 20);
  EXPECT_EQ(d.count(1), 10) << "moving the ends suffices";
  expect_within(d, 1.3);
}

TEST(LimitGrowth, CountsRiseWhereMovingEndsDoesNotSuffice) {
  Divided d(hand_made::row({1, 1}), 0.1, {30, 1});
  const GrowthOutcome outcome = limit_growth(d.input(), d.divisions);
  EXPECT_LE(outcome.worst, 1.3 * (1 + 1e-6));
  EXPECT_EQ(d.count(0), 30);
  EXPECT_GT(d.count(1), 1);
  EXPECT_LT(d.count(1), 20);
  EXPECT_EQ(outcome.raised_chords, 1);
  expect_within(d, 1.3);
}

TEST(LimitGrowth, CountsStayWhereMoreIntervalsCanShareTheGrowth) {
  // With no weight on the excess, few intervals beside the node grow by more than the limit: by 1.38.
  Divided d(hand_made::row({1, 1}), 0.1, {40, 4});
  sizing::ArcDivisions evenly = d.divisions;
  DivisionSmoother(d.input(), d.divisions).smooth({}, evenly);
  EXPECT_GT(greatest_ratio(d, evenly), 1.35);
  const GrowthOutcome outcome = limit_growth(d.input(), d.divisions);
  EXPECT_LE(outcome.worst, 1.3);
  EXPECT_EQ(outcome.raised_chords, 0);
  EXPECT_EQ(d.count(0), 40);
  EXPECT_EQ(d.count(1), 4);
  expect_within(d, 1.3);
}

TEST(LimitGrowth, PrescribedCountsStay) {
  Divided d(hand_made::row({1, 1}), 0.1, {30, 1});
  GrowthInput input = d.input();
  input.keeps_count.assign(d.measured.chords().size(), true);
  const GrowthOutcome outcome = limit_growth(input, d.divisions);
  EXPECT_EQ(d.count(1), 1);
  EXPECT_GT(outcome.worst, 1.3);
}

TEST(LimitGrowth, LayersDoNotMoveAndIntervalsGrowFromThem) {
  Divided d(hand_made::row({1, 1}), 0.1);
  GrowthInput input = d.input();
  input.layers.assign(d.measured.num_arcs(), {0, 0});
  for (const int side : {0, 2}) {
    const int arc = d.arc(0, side);
    const bool from_left = starts_at_left(d, arc);
    std::vector<double>& ends = d.divisions[arc].ends;
    ends[from_left ? 1 : ends.size() - 2] = from_left ? 0.01 : 0.99;
    input.layers[arc][from_left ? 0 : 1] = 1;
  }
  const GrowthOutcome outcome = limit_growth(input, d.divisions);
  EXPECT_LE(outcome.worst, 1.3 * (1 + 1e-6));
  EXPECT_NEAR(d.length(0, 0), 0.01, 1e-12);
  EXPECT_LE(d.length(0, 1), 0.013 * (1 + 1e-6));
}

TEST(LimitGrowth, CountsRiseByATenthOfTheFreeIntervalsHoweverManyLayersThereAre) {
  constexpr int layers = 100, count = 102;
  Divided d(hand_made::row({1, 1}), 0.1, {count, 10});
  GrowthInput input = d.input();
  input.layers.assign(d.measured.num_arcs(), {0, 0});
  for (const int side : {0, 2}) {
    const int arc = d.arc(0, side);
    const bool from_left = starts_at_left(d, arc);
    std::vector<double>& ends = d.divisions[arc].ends;
    for (int k = 0; k <= count; ++k) {
      const double x = k <= layers ? 0.002 * k : 0.2 + 0.4 * (k - layers);
      ends[from_left ? k : count - k] = from_left ? x : 1 - x;
    }
    input.layers[arc][from_left ? 0 : 1] = layers;
  }
  const GrowthOutcome outcome = limit_growth(input, d.divisions);
  EXPECT_LE(outcome.worst, 1.3 * (1 + 1e-6));
  EXPECT_LE(d.count(0), layers + 30) << "with tenths of all intervals 38 above the layers";
}

TEST(LimitGrowth, MirrorImagesAreDividedAlike) {
  Divided d(hand_made::row({0.2, 1, 0.2}), 0.1, {12, 4, 12});
  limit_growth(d.input(), d.divisions);
  EXPECT_EQ(d.count(0), d.count(2));
  for (int k = 0; k < d.count(0); ++k) EXPECT_NEAR(d.length(0, k), d.length(2, d.count(2) - 1 - k), 1e-7);
  for (int k = 0; k < d.count(1); ++k) EXPECT_NEAR(d.length(1, k), d.length(1, d.count(1) - 1 - k), 1e-7);
}

}  // namespace
}  // namespace quadrille::growth
