#include "growth/smooth_divisions.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "divided.hpp"

namespace quadrille::growth {
namespace {

/// Two squares side by side.
Divided two_squares(int left, int right) { return Divided(hand_made::row({1, 1}), 0.5, {left, right}); }

TEST(AdjacentIntervals, FollowEachOtherOnArcsAndAcrossNodes) {
  Divided d = two_squares(2, 3);
  int num_pairs = 2;  // across the nodes below and above the common side
  for (const sizing::ArcDivision& division : d.divisions) num_pairs += division.num_intervals() - 1;
  const std::vector<IntervalPair> pairs = adjacent_intervals(d.input(), d.divisions);
  EXPECT_EQ(std::ssize(pairs), num_pairs);
  int num_across = 0;
  for (const auto& [a, b] : pairs) {
    if (a.arc == b.arc) continue;
    ++num_across;
    EXPECT_NEAR(std::abs(log_growth(d.input(), d.divisions, {a, b})), std::log(1.5), 1e-12);
    EXPECT_NEAR(log_growth(d.input(), d.divisions, {a, b}), -log_growth(d.input(), d.divisions, {b, a}), 1e-15);
  }
  EXPECT_EQ(num_across, 2);
}

TEST(AdjacentIntervals, OfLayersAloneAreNone) {
  Divided d = two_squares(4, 4);
  GrowthInput input = d.input();
  const std::size_t before = adjacent_intervals(input, d.divisions).size();
  input.layers.assign(d.measured.num_arcs(), {0, 0});
  const int arc = d.arc(0, 0);
  input.layers[arc][1] = 3;
  EXPECT_FALSE(is_layer(input, d.divisions, {arc, 0}));
  for (const int k : {1, 2, 3}) EXPECT_TRUE(is_layer(input, d.divisions, {arc, k})) << k;
  EXPECT_EQ(adjacent_intervals(input, d.divisions).size(), before - 2) << "of three layers";
}

TEST(FixedFractions, AreBreaksOfCadCurvesAndNoneInside) {
  Divided d(hand_made::elbow(), 0.3);
  std::size_t num_fixed = 0;
  for (int arc = 0; arc < d.measured.num_arcs(); ++arc) {
    const std::vector<double> fixed = fixed_fractions(d.input(), arc);
    EXPECT_TRUE(d.measured.is_on_cad_curve(arc) || fixed.empty()) << arc;
    for (const double fraction : fixed) EXPECT_TRUE(fraction > 0 && fraction < 1) << fraction;
    num_fixed += fixed.size();
  }
  EXPECT_GT(num_fixed, 0u);
}

TEST(DivisionSmoother, WeightOfTheExcessReducesTheGreatestRatioOnly) {
  Divided d(hand_made::row({1, 1}), 0.1, {40, 4});
  sizing::ArcDivisions now = d.divisions;
  DivisionSmoother(d.input(), d.divisions).smooth({}, now);
  double before = greatest_ratio(d, now);
  for (const double weight : {10, 30, 90}) {
    DivisionSmoother(d.input(), d.divisions).smooth({weight, 0.97}, now);
    EXPECT_LT(greatest_ratio(d, now), before) << weight;
    before = greatest_ratio(d, now);
  }
  // Within the limit it changes nothing.
  Divided even(hand_made::row({1, 1}), 0.1, {20, 16});
  sizing::ArcDivisions free = even.divisions, weighted = even.divisions;
  DivisionSmoother(even.input(), even.divisions).smooth({}, free);
  DivisionSmoother(even.input(), even.divisions).smooth({90, 0.97}, weighted);
  for (std::size_t arc = 0; arc < free.size(); ++arc) EXPECT_EQ(free[arc].ends, weighted[arc].ends);
}

TEST(DivisionSmoother, EqualIntervalsStay) {
  Divided d = two_squares(5, 5);
  const sizing::ArcDivisions before = d.divisions;
  DivisionSmoother(d.input(), d.divisions).smooth({30, 0.97}, d.divisions);
  for (std::size_t arc = 0; arc < before.size(); ++arc)
    for (std::size_t k = 0; k < before[arc].ends.size(); ++k)
      EXPECT_NEAR(d.divisions[arc].ends[k], before[arc].ends[k], 1e-12);
}

TEST(DivisionSmoother, OppositeSidesStayOppositeAndEndsInTheirOrder) {
  Divided d = two_squares(40, 4);
  DivisionSmoother(d.input(), d.divisions).smooth({}, d.divisions);
  for (const int block : {0, 1}) {
    std::vector<double> below = d.divisions[d.arc(block, 0)].ends, above = d.divisions[d.arc(block, 2)].ends;
    EXPECT_TRUE(std::is_sorted(below.begin(), below.end()));
    EXPECT_EQ(below.front(), 0);
    EXPECT_EQ(below.back(), 1);
    if (starts_at_left(d, d.arc(block, 0)) != starts_at_left(d, d.arc(block, 2))) sizing::reverse_fractions(above);
    for (std::size_t k = 0; k < below.size(); ++k) EXPECT_NEAR(below[k], above[k], 1e-9);
  }
}

TEST(DivisionSmoother, LayersAndFixedEndsDoNotMove) {
  Divided d(hand_made::elbow(), 0.3);
  GrowthInput input = d.input();
  input.layers.assign(d.measured.num_arcs(), {1, 0});
  // Intervals that differ, and breaks among their ends.
  for (sizing::ArcDivision& division : d.divisions)
    for (double& end : division.ends) end *= (1 + end) / 2;
  for (int arc = 0; arc < d.measured.num_arcs(); ++arc)
    for (const double fraction : fixed_fractions(input, arc))
      for (double& end : d.divisions[arc].ends)
        if (std::abs(end - fraction) < 0.02) end = fraction;
  const sizing::ArcDivisions before = d.divisions;
  DivisionSmoother(input, before).smooth({}, d.divisions);
  bool has_moved = false;
  for (int arc = 0; arc < d.measured.num_arcs(); ++arc) {
    const std::vector<double>&was = before[arc].ends, &is = d.divisions[arc].ends;
    EXPECT_EQ(is[1], was[1]) << "the end of the layer";
    for (std::size_t k = 0; k < was.size(); ++k) {
      const bool is_fixed = sizing::has_fraction(fixed_fractions(input, arc), was[k]);
      EXPECT_TRUE(!is_fixed || is[k] == was[k]) << arc;
      has_moved = has_moved || is[k] != was[k];
    }
  }
  EXPECT_TRUE(has_moved);
}

}  // namespace
}  // namespace quadrille::growth
