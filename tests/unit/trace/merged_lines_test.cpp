#include "trace/merged_lines.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "../support/square_field.hpp"
#include "../support/two_nodes.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "trace/advance.hpp"
#include "trace/launch.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::trace {
namespace {

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

TEST(ChooseMerges, APairThatBendsWaitsForOneThatFits) {
  MergeCandidate bent = pair(0, 1, 1);
  bent.deviation = 0.2;
  EXPECT_GT(bent.delayed_meeting(), pair(1, 2, 1.1).delayed_meeting());
  EXPECT_LT(bent.delayed_meeting(), pair(1, 2, 1.3).delayed_meeting());
  EXPECT_EQ(choose({pair(1, 2, 1.1), bent, pair(0, 3, 1.25)}, {true, true, true}), (std::vector<int>{0, 2}));
}

using Complex = std::complex<double>;

// v = -e^{i skew} (z^2 - 1/4), as in merge_test: two separatrices pass each other head on and turn when merged.
struct Passing : testing::Test {
  static Vec2 value(Vec2 p) {
    const Complex z(p.x, p.y), v = -std::polar(1.0, 0.2) * (z * z - 0.25);
    return {v.real(), v.imag()};
  }

  std::vector<Streamline> traced(double max_length) const {
    std::vector<Streamline> lines;
    for (int n = 0; n < 2; ++n) {
      const mesh::Location at = evaluator.locator().find(nodes[n]);
      for (const double angle : launch_directions(evaluator.sample(at.elem, at.xi).dv_dx))
        lines.push_back(advance(evaluator, launch_line(evaluator, n, nodes[n], angle, 1e-4, 1), PointGrid(nodes),
                                {1e-11, 0.1, max_length, 1e-7}));
    }
    return lines;
  }

  const std::vector<Vec2> nodes{{-0.5, 0}, {0.5, 0}};
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 4), 2, value);
  field::FieldEvaluator evaluator{field};
};

TEST_F(Passing, LinesWithAnEndFollowTheRules) {
  const auto lines = traced(10);
  EXPECT_TRUE(MergePlan(evaluator, lines, nodes, {radians(0.1), 0}).choose()->empty());
  EXPECT_EQ(MergePlan(evaluator, lines, nodes, {radians(20), 0}).choose()->size(), 1u);
}

TEST_F(Passing, EndlessLinesAreMergedWhateverTheirDeviation) {
  // So short a bound that the two lines that pass each other have no end, while the others reach the boundary.
  const auto lines = traced(1.2);
  int endless = 0;
  for (const Streamline& line : lines) endless += line.end == Streamline::End::length;
  ASSERT_EQ(endless, 2);
  MergePlan plan(evaluator, lines, nodes, {radians(0.1), 0});
  const std::vector<int> chosen = plan.choose().value();
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(lines[plan.candidate(chosen[0]).a].end, Streamline::End::length);
  EXPECT_EQ(lines[plan.candidate(chosen[0]).b].end, Streamline::End::length);
}

TEST_F(Passing, AStuckLineWithoutPartnerIsFoundBeforeLinesAreContinued) {
  auto lines = traced(1.2);
  const std::vector<double> reaches(lines.size(), 4);
  MergePlan plan(evaluator, lines, nodes, {radians(0.1), 0}, reaches);
  EXPECT_FALSE(plan.choose()) << "longer lines might have partners";
  EXPECT_FALSE(plan.stuck_without_partner());
  int endless = 0;
  while (!lines[endless].is_endless()) ++endless;
  EXPECT_EQ(plan.unsettled().size(), 2u);
  EXPECT_EQ(*plan.unsettled().begin(), endless);
  const StreamStep last = lines[endless].steps.back();
  lines[endless].steps.resize(max_stream_steps, last);
  EXPECT_EQ(plan.stuck_without_partner(), endless);
  const auto now_stuck = traced(1.2);
  EXPECT_FALSE(MergePlan(evaluator, now_stuck, nodes, {radians(20), 0}, reaches).stuck_without_partner());
}

TEST_F(Passing, LinesOfAPairThatMeetsBeforeTheirReachAreSettled) {
  const auto lines = traced(1.2);
  const auto unsettled_at = [&](double reach) {
    MergePlan plan(evaluator, lines, nodes, {radians(20), 0}, std::vector(lines.size(), reach));
    const bool is_decided = plan.choose().has_value();
    EXPECT_EQ(is_decided, plan.unsettled().empty());
    return plan.unsettled();
  };
  EXPECT_TRUE(unsettled_at(2).empty());
  EXPECT_EQ(unsettled_at(1.1).size(), 2u) << "a pair that is not known yet might come first";
  for (const int line : unsettled_at(1.1)) EXPECT_TRUE(lines[line].is_endless());
}

// The second line from the first node meets the same partner a little later; it has no end.
TEST_F(Passing, LinesOfAMergeThatMayBeGivenUpAreFollowedToTheirEnds) {
  const auto from_first = [&](double radius, const Launch& launch, double max_length) {
    return advance(evaluator, launch_line(evaluator, 0, nodes[0], launch.angle, radius, 1), PointGrid(nodes),
                   {1e-11, 0.1, max_length, 1e-7});
  };
  auto lines = traced(10);
  const std::vector<int> pair_of_ended = MergePlan(evaluator, lines, nodes, {radians(20), 0}).choose().value();
  const MergeCandidate pair = MergePlan(evaluator, lines, nodes, {radians(20), 0}).candidate(pair_of_ended.at(0));
  const Streamline whole = lines[pair.b];
  lines.push_back(from_first(0.03, lines[pair.a].launch, 1.2));
  const int endless = static_cast<int>(lines.size()) - 1;
  ASSERT_TRUE(lines[endless].is_endless());
  std::vector<double> reaches(lines.size(), 0);
  lines[pair.b] = traced(1.2)[pair.b];
  reaches[pair.b] = 1.6;
  MergePlan plan(evaluator, lines, nodes, {radians(20), 0}, reaches);
  EXPECT_FALSE(plan.choose());
  EXPECT_EQ(plan.unsettled(), std::set{pair.b});
  lines[pair.b] = whole;
  MergePlan complete(evaluator, lines, nodes, {radians(20), 0});
  const std::vector<int> chosen = complete.choose().value();
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_EQ(complete.candidate(chosen[0]).b, endless);
}

TEST_F(Passing, RejectedMergesAreNotChosenAgain) {
  const auto lines = traced(10);
  MergePlan plan(evaluator, lines, nodes, {radians(20), 0});
  const std::vector<int> chosen = plan.choose().value();
  ASSERT_EQ(chosen.size(), 1u);
  EXPECT_FALSE(plan.reject_worst(chosen, 2 * plan.candidate(chosen[0]).deviation));
  EXPECT_EQ(plan.choose(), chosen);
  EXPECT_TRUE(plan.reject_worst(chosen, 0));
  EXPECT_TRUE(plan.choose()->empty());
  EXPECT_FALSE(plan.reject_worst({}, 0));
}

TEST(FamilyOrder, ACrossingAtASmallAngleIsNamedUnlessAMergeHasMadeIt) {
  const std::vector<graph::Crossing> crossings{{0, 1, 1, 1, {2, 3}, half_pi}, {1, 2, 1, 1, {4, 5}, 0.2}};
  EXPECT_NO_THROW(require_family_order({crossings[0]}, {false, false, false}, CadFace()));
  EXPECT_NO_THROW(require_family_order(crossings, {false, false, true}, CadFace()));
  EXPECT_NO_THROW(require_family_order(crossings, {false, true, false}, CadFace()));
  try {
    CadFace face;
    face.origin = {100, 0};
    require_family_order(crossings, {true, false, false}, face);
    FAIL();
  } catch (const FamilyOrderError& error) {
    EXPECT_NE(std::string(error.what()).find("(104, 5)"), std::string::npos) << error.what();
    EXPECT_NE(std::string(error.what()).find("11.5 degrees"), std::string::npos) << error.what();
  }
}

// Lines from places along all sides of a square, past two nodes of valence 3 through many elements: those of one family
// keep their sequence everywhere, for any two meet at right angles or not at all.
TEST(FamilyOrder, IsKeptBesideNodes) {
  const auto value = [](Vec2 p) {
    const std::complex<double> z(p.x, p.y), v = -std::polar(1.0, 0.3) * (z * z - 0.25);
    return Vec2{v.real(), v.imag()};
  };
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 6), 2, value);
  const field::FieldEvaluator evaluator(field);
  std::vector<Nurbs> splines;
  for (int side = 0; side < 4; ++side)
    for (int i = 1; i < 12; ++i) {
      const Launch launch = launch_from_boundary(evaluator, side, i / 6.0);
      const Streamline line = advance(evaluator, launch, PointGrid({{-0.5, 0}, {0.5, 0}}), {1e-10, 0.1, 6, 1e-7});
      const auto along = [&](double s, Vec2& direction) { return line.at(evaluator, s, direction); };
      if (line.length() > 0.01) splines.push_back(curve::fit_line(along, line.length(), 1e-9));
    }
  const std::vector<graph::Crossing> crossings = graph::find_crossings(splines, 1e-9);
  EXPECT_GT(crossings.size(), 50u);
  int num_twice = 0;
  for (const graph::Crossing& c : crossings) {
    // Launched across the boundary, not along the cross: the first step alone may bend.
    if (std::min(c.s, c.t) < 1e-3) continue;
    EXPECT_NEAR(c.angle, half_pi, 1e-4) << c.position.x << ' ' << c.position.y;
    EXPECT_FALSE(is_of_one_family(c));
    num_twice += c.a == c.b ? 1 : 0;
  }
  EXPECT_LT(num_twice, 10);
}

Vec2 first(const Nurbs& spline) { return curve::point(spline, spline.begin()); }
Vec2 last(const Nurbs& spline) { return curve::point(spline, spline.end()); }

TEST_F(TwoNodes, ASingleLineIsFittedFromItsNodeToItsEnd) {
  make(0.2);
  LineFitter fitter(*evaluator, lines);
  for (int k = 0; k < static_cast<int>(lines.size()); ++k) {
    const MergedLine line = fitter.single(k);
    EXPECT_EQ(line.streamline, k);
    EXPECT_EQ(line.merge, -1);
    EXPECT_EQ(line.length, lines[k].length());
    EXPECT_EQ(line.line.kind, LineKind::traced);
    EXPECT_EQ(line.line.start.node, lines[k].launch.start.node);
    EXPECT_EQ(line.line.end.curve, lines[k].reached.curve);
    EXPECT_EQ(line.line.end.t, lines[k].reached.t);
    EXPECT_EQ(first(line.line.spline), nodes[lines[k].launch.start.node]);
    EXPECT_EQ(last(line.line.spline), lines[k].end_position);
  }
}

TEST_F(TwoNodes, SplinesFollowTheirLines) {
  make(0.2);
  LineFitter fitter(*evaluator, lines);
  const Nurbs spline = fitter.single(0).line.spline;
  for (int i = 0; i <= 50; ++i) {
    const double s = lines[0].length() * i / 50;
    EXPECT_LT(distance(curve::point(spline, s), lines[0].at(*evaluator, s)),
              2 * graph::relative_fit_tol * field.mesh.face.diameter);
  }
}

TEST_F(TwoNodes, ALineFromTheBoundaryIsACut) {
  make(0);
  lines.push_back(advance(*evaluator, launch_from_boundary(*evaluator, 0, 0.5), PointGrid({}), {1e-11, 0.1, 10, 1e-7}));
  LineFitter fitter(*evaluator, lines);
  const MergedLine cut = fitter.single(static_cast<int>(lines.size()) - 1);
  EXPECT_EQ(cut.line.kind, LineKind::cut);
  EXPECT_EQ(cut.line.start.node, -1);
  EXPECT_EQ(cut.line.start.curve, 0);
  EXPECT_EQ(cut.line.start.t, 0.5);
}

TEST_F(TwoNodes, AMergedPairLeadsFromNodeToNode) {
  make(0.2);
  const MergeCandidate pair = candidates(20).at(0);
  LineFitter fitter(*evaluator, lines);
  const MergedLine merged = fitter.pair(pair, 7);
  EXPECT_EQ(merged.line.kind, LineKind::merged);
  EXPECT_EQ(merged.merge, 7);
  EXPECT_EQ(merged.streamline, pair.a);
  EXPECT_NEAR(merged.length, pair.length(), 1e-15);
  EXPECT_EQ(merged.line.start.node, lines[pair.a].launch.start.node);
  EXPECT_EQ(merged.line.end.node, lines[pair.b].launch.start.node);
  EXPECT_EQ(first(merged.line.spline), nodes[lines[pair.a].launch.start.node]);
  EXPECT_EQ(last(merged.line.spline), nodes[lines[pair.b].launch.start.node]);
}

TEST_F(TwoNodes, EqualKeysMeanTheSameCurveAndOthersDoNot) {
  make(0.2);
  const MergeCandidate pair = candidates(20).at(0);
  MergeCandidate join = pair;
  join.is_join = true;
  LineFitter fitter(*evaluator, lines);
  EXPECT_EQ(fitter.single(0).key, fitter.single(0).key);
  EXPECT_NE(fitter.single(0).key, fitter.single(1).key);
  EXPECT_EQ(fitter.pair(pair, 0).key, fitter.pair(pair, 3).key);
  EXPECT_NE(fitter.pair(pair, 0).key, fitter.single(pair.a).key);
  EXPECT_NE(fitter.pair(pair, 0).key, fitter.pair(join, 0).key);
  EXPECT_EQ(fitter.single(0).line.spline.knots, fitter.single(0).line.spline.knots);
}

TEST_F(TwoNodes, ALineThatWasContinuedIsFittedAgain) {
  make(0);
  LineFitter fitter(*evaluator, lines);
  lines[0] = advance(*evaluator, lines[0].launch, PointGrid(nodes), {1e-11, 0.1, 0.2, 1e-7});
  const MergedLine brief = fitter.single(0);
  EXPECT_EQ(brief.line.end.node, -1);
  EXPECT_EQ(brief.line.end.curve, -1);
  follow(*evaluator, lines[0], PointGrid(nodes), {1e-11, 0.1, 10, 1e-7});
  const MergedLine whole = fitter.single(0);
  EXPECT_NE(brief.key, whole.key);
  EXPECT_GT(whole.line.spline.end(), brief.line.spline.end());
}

struct MergedTwoNodes : TwoNodes {
  MergedLines merged(double degrees_allowed, LineEnds ends = LineEnds::required,
                     std::vector<double> reaches = {}) const {
    return MergedLines(*evaluator, lines, nodes, radians(degrees_allowed), 0, ends, {std::move(reaches)});
  }
  void follow_only_to(double length) {
    for (Streamline& line : lines)
      line = advance(*evaluator, line.launch, PointGrid(nodes), {1e-11, 0.1, length, 1e-7});
  }
};

TEST_F(MergedTwoNodes, AMergedPairIsOneLineFromNodeToNode) {
  make(0.2);
  MergedLines all = merged(20);
  ASSERT_TRUE(all.merge());
  ASSERT_EQ(all.chosen().size(), 1u);
  ASSERT_EQ(all.arrangement().lines.size(), 5u);
  int num_merged = 0;
  for (const MergedLine& line : all.arrangement().lines) {
    if (line.merge < 0) {
      EXPECT_GE(line.line.end.curve, 0);
      continue;
    }
    ++num_merged;
    EXPECT_EQ(line.line.kind, LineKind::merged);
    EXPECT_EQ(line.line.start.node, 0);
    EXPECT_EQ(line.line.end.node, 1);
    EXPECT_LT(distance(curve::point(line.line.spline, line.length), nodes[1]), 1e-9);
  }
  EXPECT_EQ(num_merged, 1);
  EXPECT_GT(all.largest_deviation(), radians(1));
}

TEST_F(MergedTwoNodes, ARejectedMergeLeavesBothLines) {
  make(0.2);
  MergedLines all = merged(20);
  all.merge();
  EXPECT_FALSE(all.reject_worst(all.chosen(), 2 * all.largest_deviation()));
  ASSERT_TRUE(all.reject_worst(all.chosen(), 0));
  all.merge();
  EXPECT_EQ(all.arrangement().lines.size(), 6u);
  EXPECT_EQ(all.largest_deviation(), 0);
}

TEST_F(MergedTwoNodes, ARejectedPairStaysRejectedWhenItsLinesAreFollowedFarther) {
  make(0.2);
  follow_only_to(1.2);
  MergedLines all = merged(20, LineEnds::optional);
  all.merge();
  ASSERT_EQ(all.chosen().size(), 1u);
  ASSERT_TRUE(all.reject_worst(all.chosen(), 0));
  follow_only_to(10);
  all.renew();
  all.merge();
  EXPECT_TRUE(all.chosen().empty());
}

TEST_F(MergedTwoNodes, LinesWithoutAnEndAreAnErrorOnlyWhereEndsAreRequired) {
  make(0.2);
  follow_only_to(0.3);
  EXPECT_THROW(merged(0.1).merge(), ComputeError);
  MergedLines stopped = merged(0.1, LineEnds::optional);
  EXPECT_TRUE(stopped.merge());
  EXPECT_EQ(stopped.arrangement().lines.size(), 6u);
}

TEST_F(MergedTwoNodes, LinesThatAreTooShortToDecideSaySo) {
  make(0.2);
  follow_only_to(0.3);
  EXPECT_FALSE(merged(20, LineEnds::required, std::vector(lines.size(), 0.3)).merge());
}

TEST_F(MergedTwoNodes, CrossingsAtACommonEndAreNotInner) {
  make(0);
  MergedLines all = merged(20);
  all.merge();
  for (const graph::Crossing& c : all.arrangement().inner_crossings)
    for (const Vec2 node : nodes) EXPECT_GT(distance(c.position, node), 1e-6);
}

}  // namespace
}  // namespace quadrille::trace
