#include "trace/merge_plan.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"
#include "trace/advance.hpp"
#include "trace/launch_directions.hpp"

namespace quadrille::trace {
namespace {

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
  MergePlan plan(evaluator, lines, nodes, {radians(0.1), 0}, 4);
  EXPECT_FALSE(plan.choose()) << "longer lines might have partners";
  EXPECT_FALSE(plan.stuck_without_partner());
  int endless = 0;
  while (!lines[endless].is_endless()) ++endless;
  const StreamStep last = lines[endless].steps.back();
  lines[endless].steps.resize(max_stream_steps, last);
  EXPECT_EQ(plan.stuck_without_partner(), endless);
  const auto merged_by_rules = MergePlan(evaluator, traced(1.2), nodes, {radians(20), 0}, 4).stuck_without_partner();
  EXPECT_FALSE(merged_by_rules);
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

}  // namespace
}  // namespace quadrille::trace
