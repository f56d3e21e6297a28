#include "refine/divide_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "sizing/interval_error.hpp"

namespace quadrille::refine {
namespace {

struct Divided {
  BlockLayout layout;
  std::vector<std::vector<double>> ends;
  std::vector<std::vector<double>> breaks;
  std::vector<double> lengths;
  double worst = 0;  ///< error of the boundary's intervals
};

struct Options {
  double size;
  int order;
  double tolerance;
};

Divided divided(const SeparatrixGraph& graph, const Options& options) {
  Report report;
  Divided d{block::extract_blocks(graph, report), {}, {}, {}};
  const sizing::MeasuredLayout measured(d.layout);
  const std::vector<sizing::ChordPlan> plans =
      sizing::grade_chords(measured, sizing::SizeField(options.size), sizing::SizeRule::at_most, {});
  for (sizing::ArcDivision& division : divide_arcs(measured, plans, {options.order, options.tolerance}))
    d.ends.push_back(std::move(division.ends));
  for (int a = 0; a < measured.num_arcs(); ++a) {
    d.breaks.push_back(measured.chain(a).break_fractions());
    d.lengths.push_back(measured.length(a));
    if (!d.layout.arcs[a].is_boundary) continue;
    for (std::size_t k = 1; k < d.ends[a].size(); ++k)
      d.worst = std::max(d.worst, sizing::interval_error(measured.curves(), measured.chain(a), d.ends[a][k - 1],
                                                         d.ends[a][k], options.order));
  }
  return d;
}

TEST(DivideArcs, ArcsOfAChordHaveTheSameCount) {
  const Divided d = divided(hand_made::cut_annulus(3), {0.1, 4, 1e-6});
  for (std::size_t a = 0; a < d.ends.size(); ++a)
    for (std::size_t b = 0; b < a; ++b)
      if (d.layout.arc_chord[a] == d.layout.arc_chord[b]) {
        EXPECT_EQ(d.ends[a].size(), d.ends[b].size());
      }
}

TEST(DivideArcs, ChordsWithAKnownPlanKeepTheirDivisions) {
  Report report;
  const BlockLayout layout = block::extract_blocks(hand_made::cut_annulus(3), report);
  const sizing::MeasuredLayout measured(layout);
  const auto plans_of = [&](double size) {
    return sizing::grade_chords(measured, sizing::SizeField(size), sizing::SizeRule::at_most, {});
  };
  std::vector<sizing::ChordPlan> known = plans_of(0.3), plans = known;
  plans[0] = plans_of(0.05)[0];
  ASSERT_NE(plans[0], known[0]);
  const DivideOptions options{4, 1e-6};
  sizing::ArcDivisions marked = divide_arcs(measured, known, options);
  for (sizing::ArcDivision& division : marked) division.ends = {0, 0.123, 1};
  const sizing::ArcDivisions expected = divide_arcs(measured, plans, options);
  const sizing::ArcDivisions found = divide_arcs(measured, plans, options, nullptr, {&known, &marked});
  for (int a = 0; a < measured.num_arcs(); ++a)
    EXPECT_EQ(found[a].ends, measured.chord_of(a) == 0 ? expected[a].ends : marked[a].ends);
}

TEST(DivideArcs, AnIntervalEndsWhereAGivenNameDoesHoweverLooseTheTolerance) {
  SeparatrixGraph graph = hand_made::elbow();
  const auto has_end_at_breaks = [](const Divided& d, std::size_t arc) {
    return std::all_of(d.breaks[arc].begin(), d.breaks[arc].end(), [&](double b) {
      return std::any_of(d.ends[arc].begin(), d.ends[arc].end(), [&](double e) { return std::abs(e - b) < 1e-12; });
    });
  };
  const auto broken_arcs_with_ends = [&](const Divided& d) {
    int broken = 0, good = 0;
    for (std::size_t arc = 0; arc < d.ends.size(); ++arc) {
      broken += !d.breaks[arc].empty();
      good += !d.breaks[arc].empty() && has_end_at_breaks(d, arc);
    }
    return std::pair(broken, good);
  };
  EXPECT_EQ(broken_arcs_with_ends(divided(graph, {0.7, 4, 1})), std::pair(2, 0));
  hand_made::give_name(graph.face, 1, "bend");
  EXPECT_EQ(broken_arcs_with_ends(divided(graph, {0.7, 4, 1})).second, 1);
  for (const int curve : {3, 4}) hand_made::give_name(graph.face, curve, "inner");  // one name on both sides: no end
  EXPECT_EQ(broken_arcs_with_ends(divided(graph, {0.7, 4, 1})).second, 1);
  hand_made::give_name(graph.face, 4, "inlet");
  EXPECT_EQ(broken_arcs_with_ends(divided(graph, {0.7, 4, 1})).second, 2);
}

TEST(DivideArcs, SizeBoundsTheLongestArcOfAChord) {
  const Divided d = divided(hand_made::quarter_annulus(), {0.3, 8, 1e-6});
  EXPECT_EQ(d.ends[1].size() - 1, 11u);  // pi / 0.3 = 10.47
  EXPECT_EQ(d.ends[0].size() - 1, 4u);   // 1 / 0.3 = 3.33
}

TEST(DivideArcs, ExactMultiplesOfTheSizeAreNotRaised) {
  EXPECT_EQ(divided(hand_made::unit_square(), {0.1, 4, 1e-6}).ends[0].size() - 1, 10u);
}

TEST(DivideArcs, ToleranceIsMetWithCutsOnBreaks) {
  for (const int order : {1, 2, 4, 8}) {
    const Divided d = divided(hand_made::elbow(), {1.5, order, 1e-5});
    EXPECT_LE(d.worst, 1e-5) << order;
    for (const int arc : {0, 2}) {
      ASSERT_EQ(d.breaks[arc].size(), 1u);
      EXPECT_EQ(std::count(d.ends[arc].begin(), d.ends[arc].end(), d.breaks[arc][0]), 1) << order;
    }
  }
}

TEST(DivideArcs, KnotsSpreadOverAnIntervalAreNoCutsBeforeItIsShort) {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int k = 0; k <= 100; ++k) {
    const double x = k / 100.0;
    parameters.push_back(x);
    points.push_back({x, 0.05 * std::sin(2 * pi * x)});
  }
  const Vec2 slope{1, 0.1 * pi};
  const std::vector<Nurbs> loop{curve::cubic_spline(parameters, points, slope, slope), curve::segment({1, 0}, {1, 1}),
                                curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  const Divided d =
      divided(hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}}), {10, 4, 1e-5});
  EXPECT_GT(d.breaks[0].size(), 50u);
  EXPECT_LE(d.worst, 1e-5);
  EXPECT_LE(d.ends[0].size() - 1, 8u);
}

TEST(DivideArcs, BreaksThatDoNoHarmAreNoCuts) {
  EXPECT_EQ(divided(hand_made::elbow(), {10, 4, 10}).ends[0].size(), 2u);
}

TEST(DivideArcs, IntervalsDoNotExceedTheSizeByMoreThanAQuarter) {
  for (const double size : {1.0, 0.7, 0.31, 0.1}) {
    const Divided d = divided(hand_made::s_bend(), {size, 4, 1e-6});
    for (std::size_t a = 0; a < d.ends.size(); ++a)
      for (std::size_t k = 1; k < d.ends[a].size(); ++k)
        EXPECT_LE((d.ends[a][k] - d.ends[a][k - 1]) * d.lengths[a], 1.25 * size + 1e-12);
  }
}

TEST(DivideArcs, ClosedAndParallelArcsGetEnoughElements) {
  EXPECT_EQ(divided(hand_made::cut_annulus(1), {100, 4, 1}).ends[0].size() - 1, 3u);
  EXPECT_EQ(divided(hand_made::cut_annulus(2), {100, 4, 1}).ends[0].size() - 1, 2u);
  EXPECT_EQ(divided(hand_made::cut_annulus(3), {100, 4, 1}).ends[0].size() - 1, 1u);
}

TEST(DivideArcs, ImpossibleWishesEndWithAPlace) {
  EXPECT_THROW(divided(hand_made::quarter_annulus(), {0.1, 1, 1e-14}), ComputeError);
  EXPECT_THROW(divided(hand_made::unit_square(), {1e-9, 1, 1e-6}), ComputeError);
}

}  // namespace
}  // namespace quadrille::refine
