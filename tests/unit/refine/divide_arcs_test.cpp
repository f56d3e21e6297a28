#include "refine/divide_arcs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "../hand_made.hpp"
#include "../support/grid_layout.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "block/make_blocks.hpp"
#include "chord_samples.hpp"
#include "model/quad_mesh.hpp"
#include "refine/chord_division.hpp"
#include "sizing/interval_error.hpp"

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

// The unit square with a bump in the last fifth of its lower side.
SeparatrixGraph square_with_bump() {
  std::vector<double> parameters;
  std::vector<Vec2> points;
  for (int k = 0; k <= 50; ++k) {
    const double x = k / 50.0, t = std::max(0.0, 5 * x - 4);
    parameters.push_back(x);
    points.push_back({x, 3 * std::pow(t * (1 - t), 4)});
  }
  const std::vector<Nurbs> loop{curve::cubic_spline(parameters, points, {1, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}),
                                curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  return hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}});
}

TEST(CorrectMisses, WithoutPrescribedGrowthIntervalsBecomeShorterAloneIfVerticesAreRelaxed) {
  for (const bool alone : {false, true}) {
    const ChordSample sample(square_with_bump(), 0, 5, {2, 1e-3, alone});
    ChordDivision division = settled(sample);
    while (correct_misses(sample.task, division)) settle_counts(sample.task, division);
    const sizing::ArcDivision& lower = division.arcs[0];
    const int first = sample.measured.chords()[0].backwards[0] ? lower.num_intervals() - 1 : 0;
    EXPECT_EQ(lower.width(first) > 0.15, alone);
    EXPECT_EQ(lower.num_intervals() < 12, alone) << lower.num_intervals();
  }
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

using layers::parse_wall_spec;

/// Two blocks on top of each other, on the left of a wave: [0, w(y)] x [0, 2]; the top is the bottom moved by (0, 2).
SeparatrixGraph wavy_column() {
  const Nurbs wave{2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {2.2, 0.8}, {1, 2}}, {1, 1, 1}};
  SeparatrixGraph g = hand_made::one_block(
      hand_made::face(
          {{curve::segment({0, 0}, {1, 0}), wave, curve::segment({1, 2}, {0, 2}), curve::segment({0, 2}, {0, 0})}},
          std::sqrt(8.0)),
      {{0}, {1}, {2}, {3}});
  g.face.periodic_pairs = {{{0, 2}, 0, {0, 2}}};
  return g;
}

/// A sector of a ring from the angle 0 to a third turn; both straight sides are periodic.
SeparatrixGraph sector() {
  const double angle = 2 * pi / 3;
  const Vec2 end = unit(angle);
  SeparatrixGraph g =
      hand_made::one_block(hand_made::face({{curve::segment({1, 0}, {2, 0}), curve::circular_arc({0, 0}, 2, 0, angle),
                                             curve::segment(2 * end, end), curve::circular_arc({0, 0}, 1, angle, 0)}},
                                           4),
                           {{0}, {1}, {2}, {3}});
  g.face.periodic_pairs = {{{0, 2}, angle, {0, 0}}};
  return g;
}

/// Greatest distance of a node of the first curve, moved, from the nearest of the second, in diameters.
double greatest_gap(const QuadMesh& mesh, const PeriodicPair& pair) {
  std::vector<Vec2> second;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    if (e.curve == pair.curves[1])
      for (const int node : side_nodes(mesh, e.elem, e.side)) second.push_back(mesh.nodes[node]);
  double greatest = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges) {
    if (e.curve != pair.curves[0]) continue;
    for (const int node : side_nodes(mesh, e.elem, e.side)) {
      const Vec2 x = mesh.nodes[node], turn = unit(pair.angle);
      const Vec2 image = Vec2{turn.x * x.x - turn.y * x.y, turn.y * x.x + turn.x * x.y} + pair.shift;
      double nearest = 1e300;
      for (const Vec2 y : second) nearest = std::min(nearest, distance(image, y));
      greatest = std::max(greatest, nearest);
    }
  }
  return greatest / mesh.face.diameter;
}

TEST(MatchPeriodic, BothArcsGetTheMean) {
  std::vector<double> first{0, 0.25, 0.5, 1}, second{0, 0.5, 0.625, 1};
  match_fractions({HalfEdge{0}, HalfEdge{1}}, first, second);
  EXPECT_EQ(first, (std::vector<double>{0, 0.3125, 0.5, 1}));
  EXPECT_EQ(second, (std::vector<double>{0, 0.5, 0.6875, 1}));
  first = {0, 0.25, 1}, second = {0, 0.5, 1};
  match_fractions({HalfEdge{0}, HalfEdge{1, true}}, first, second);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first[1], 0.375);
}

TEST(MatchPeriodic, ArcsOfAPairAreOneChord) {
  const BlockLayout layout = block::extract_blocks(sector());
  const std::vector<PeriodicArcs> pairs = matched_arcs(layout);
  ASSERT_EQ(pairs.size(), 1u);
  EXPECT_EQ(pairs[0], (PeriodicArcs{HalfEdge{0}, HalfEdge{2}}));
  EXPECT_EQ(layout.arc_chord[0], layout.arc_chord[2]);
}

TEST(MatchPeriodic, NodesAreMappedOntoEachOther) {
  for (const SeparatrixGraph& graph : {sector(), wavy_column()}) {
    RefineOptions options{.size = 0.2, .order = 4};
    options.size_field = sizing::SizeField(0.2, {{{{1, 0}, 0.03, 0}}, {}, 0}, {}, 1.3);
    for (const Relax goal : {Relax::none, Relax::shape, Relax::size}) {
      options.relax = goal;
      EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
    }
  }
}

TEST(MatchPeriodic, WithLayersAtOneEndToo) {
  RefineOptions options{.size = 0.3, .order = 3};
  options.walls = {parse_wall_spec("side_1:first=0.02,layers=3")};
  for (const SeparatrixGraph& graph : {sector(), wavy_column()})
    EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
}

/// [0, 3] x [0, 4], periodic upwards, in two blocks: the line between them has a bump on the left, nearer to the
/// bottom, to which the lines from the bottom bend more than those from the top.
SeparatrixGraph bumpy_column() {
  SeparatrixGraph g;
  g.face = hand_made::face({{curve::segment({0, 0}, {3, 0}), curve::segment({3, 0}, {3, 4}),
                             curve::segment({3, 4}, {0, 4}), curve::segment({0, 4}, {0, 0})}},
                           5);
  g.face.periodic_pairs = {{{0, 2}, 0, {0, 4}}};
  for (int k = 0; k < 4; ++k) hand_made::add_joint_node(g, k);
  const int right = hand_made::add_boundary_node(g, 1, 1), left = hand_made::add_boundary_node(g, 3, 3);
  hand_made::add_arc(g, 0, 1, true, {{0, 0, 3}});
  hand_made::add_arc(g, 1, right, true, {{1, 0, 1}});
  hand_made::add_arc(g, right, 2, true, {{1, 1, 4}});
  hand_made::add_arc(g, 2, 3, true, {{2, 0, 3}});
  hand_made::add_arc(g, 3, left, true, {{3, 0, 3}});
  hand_made::add_arc(g, left, 0, true, {{3, 3, 4}});
  g.splines.push_back({3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 1}, {0.2, 2.6}, {0.6, 1}, {3, 1}}, {1, 1, 1, 1}});
  hand_made::add_arc(g, left, right, false, {{4, 0, 1}});
  return g;
}

TEST(MatchPeriodic, WhereTheBlocksBesideDiffer) {
  const SeparatrixGraph graph = bumpy_column();
  RefineOptions options{.size = 0.25, .order = 3};
  EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
  options.walls = {parse_wall_spec("side_3:first=0.02,layers=3")};
  EXPECT_LT(greatest_gap(refined(graph, options), graph.face.periodic_pairs[0]), 1e-13);
}

/// The plate [0, 3] x [0, 2] in unit squares, periodic to the right. The blocks on the left and on the right are
/// linked: a count on the right counts on the left.
SeparatrixGraph periodic_grid() {
  SeparatrixGraph g = grid_layout(3, 2);
  g.face.periodic_pairs = {{{1, 3}, 0, {-3, 0}}};
  return g;
}

TEST(MatchPeriodic, SizesOnOneSideActOnTheOther) {
  const SeparatrixGraph graph = periodic_grid();
  RefineOptions options{.size = 0.5, .order = 2};
  options.size_field = sizing::SizeField(0.5, {{{{3, 0.5}, 0.05, 0.1}}, {}, 0}, {}, 1.3);
  const QuadMesh mesh = refined(graph, options);
  EXPECT_LT(greatest_gap(mesh, graph.face.periodic_pairs[0]), 1e-13);
  EXPECT_LT(greatest_gap(mesh, {{3, 1}, 0, {3, 0}}), 1e-13) << "and as many";
}

TEST(MatchPeriodic, CutsOfAChordMatch) {
  graph::Subdivision subdivision = block::subdivision_into_blocks(periodic_grid());
  int right = 0;
  while (subdivision.graph().arcs[right].pieces.front().curve != 1) ++right;
  ASSERT_TRUE(block::split_chord(subdivision, right, std::vector<bool>(6, true)));
  EXPECT_NO_THROW(require_periodic_arcs(subdivision.graph(), ""));
  EXPECT_EQ(periodic_arcs(subdivision.graph()).size(), 3u);
}

TEST(MatchPeriodic, BlocksThatDoNotMatchAreRefused) {
  SeparatrixGraph graph = periodic_grid();
  graph.face.periodic_pairs = {{{0, 1}, 0, {0, 0}}};
  try {
    refined(graph, {.size = 0.5});
    FAIL() << "accepted";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("has no counterpart"), std::string::npos) << error.what();
  }
}

}  // namespace
}  // namespace quadrille::refine
