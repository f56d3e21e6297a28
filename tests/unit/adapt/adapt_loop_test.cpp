#include "adapt/adapt_loop.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "field/evaluate.hpp"
#include "galerkin/solve_laplace.hpp"
#include "triangulate/triangulate.hpp"

namespace quadrille::adapt {
namespace {

Field solved(const TriMesh& mesh, int order) {
  Report report;
  return galerkin::solve_laplace(mesh, std::vector<int>(mesh.num_elems(), order), report);
}

TriMesh half_disc() {
  CadFace face;
  face.diameter = 2;
  face.curves = {curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, pi)};
  face.curve_names = {"diameter", "arc"};
  face.curve_cad_edges = {0, 1};
  face.joints = {{{-1, 0}, -half_pi, 0, half_pi, true}, {{1, 0}, 0, half_pi, half_pi, true}};
  face.loop_offsets = {0, 2};
  Report report;
  return triangulate::triangulate(face, {}, report);
}

// The half disc's field in closed form (lib/method.md §2).
Vec2 half_disc_field(Vec2 x) {
  const double r = norm(x), angle = angle_of(x);
  double u = 1, power = r;
  for (int n = 1; n < 600; n += 2, power *= r * r) {
    u -= 4 / pi * (1.0 / n - n / (n * n - 16.0)) * power * std::sin(n * angle);
  }
  return {u, std::pow(r, 4) * std::sin(4 * angle)};
}

TEST(AdaptLoop, ReachesTheClosedFormOfTheHalfDisc) {
  Report report;
  const Field field = adapt_loop(solved(half_disc(), 8), {}, report);
  const field::FieldEvaluator evaluator(field);
  double worst = 0;
  for (double angle = 0.05; angle < pi; angle += 0.1) {
    for (const double r : {0.05, 0.3, 0.7, 0.9}) {
      Vec2 value;
      ASSERT_TRUE(evaluator.value_at(r * unit(angle), value));
      worst = std::max(worst, distance(value, half_disc_field(r * unit(angle))));
    }
  }
  EXPECT_LT(worst, 1e-8);
  // The zeros lie where the closed form has them, to far less than the 1e-7 that blocks need.
  const Vec2 zero{0.50508102270043128, 0.50508102270043128};
  const mesh::Location at = evaluator.locator().find(zero);
  const field::FieldSample sample = evaluator.sample(at.elem, at.xi);
  EXPECT_LT(norm(inverse(sample.dv_dx) * sample.value), 1e-9 * 2);
  EXPECT_TRUE(report.warnings().empty());
}

TEST(AdaptLoop, LowersAConstantToTheLeastOrderAsInThePaper) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 3);
  Report report;
  const Field field = adapt_loop(solved(mesh, 8), {.policy = AdaptPolicy::paper, .min_order = 2}, report);
  EXPECT_EQ(field.elem_order, std::vector<int>(mesh.num_elems(), 2));
  EXPECT_EQ(field.adapt_steps.size(), 7u);
  EXPECT_EQ(field.adapt_steps.front().num_lowered, mesh.num_elems());
  EXPECT_EQ(field.adapt_steps.back().num_lowered, 0);
}

TEST(AdaptLoop, PredictionKeepsASolutionThatIsResolved) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {1, 0}, {0, 1}, 3);
  Report report;
  const Field field = adapt_loop(solved(mesh, 8), {.min_order = 2}, report);
  EXPECT_EQ(field.elem_order, std::vector<int>(mesh.num_elems(), 8));
  EXPECT_EQ(field.adapt_steps.size(), 1u);
}

TEST(AdaptLoop, PredictionLowersOrdersWhereOthersAreRaised) {
  Report report;
  const Field field = adapt_loop(solved(half_disc(), 12), {}, report);
  EXPECT_GT(field.adapt_steps.front().num_lowered, 0);
  EXPECT_GT(field.adapt_steps.front().num_raised, 0);
}

TEST(AdaptLoop, NeedsTwoNewSolutionsByPredictionForNearlyTheOrdersOfThePaper) {
  for (const int order : {8, 10, 12}) {
    Report report;
    const Field predicted = adapt_loop(solved(half_disc(), order), {}, report);
    const Field paper = adapt_loop(solved(half_disc(), order), {.policy = AdaptPolicy::paper}, report);
    EXPECT_LE(predicted.adapt_steps.size(), 3u) << "from order " << order;
    EXPECT_GT(paper.adapt_steps.size(), predicted.adapt_steps.size());
    EXPECT_LT(predicted.adapt_steps.back().num_unknowns, 1.2 * paper.adapt_steps.back().num_unknowns);
    EXPECT_LE(predicted.adapt_steps.back().max_sensor, AdaptOptions{}.raise_above);
  }
}

void expect_sensors_inside_limits(AdaptPolicy policy) {
  const TriMesh mesh = parallelogram_mesh({0, 0}, {2, 0}, {0.7, 1}, 4);
  const AdaptOptions options{
      .policy = policy, .raise_above = 1e-10, .lower_below = 1e-14, .min_order = 2, .max_order = 12};
  Report report;
  const Field field = adapt_loop(solved(mesh, 5), options, report);
  EXPECT_EQ(field.adapt_steps.back().num_raised + field.adapt_steps.back().num_lowered, 0);
  const auto [low, high] = std::minmax_element(field.elem_order.begin(), field.elem_order.end());
  EXPECT_GE(*low, 2);
  EXPECT_LE(*high, 12);
  EXPECT_GT(*high, *low);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    EXPECT_TRUE(field.elem_sensor[e] <= options.raise_above || field.elem_order[e] == 12);
  }
}

TEST(AdaptLoop, EndsWithEverySensorInsideItsLimits) {
  expect_sensors_inside_limits(AdaptPolicy::predict);
  expect_sensors_inside_limits(AdaptPolicy::paper);
}

TEST(AdaptLoop, AdaptedFieldsStayAsTheyAre) {
  Report report;
  for (const AdaptPolicy policy : {AdaptPolicy::predict, AdaptPolicy::paper}) {
    const AdaptOptions options{.policy = policy};
    const Field once = adapt_loop(solved(half_disc(), 8), options, report), twice = adapt_loop(once, options, report);
    EXPECT_EQ(once.elem_order, twice.elem_order);
    EXPECT_EQ(once.u, twice.u);
    EXPECT_EQ(once.adapt_steps.size(), twice.adapt_steps.size());
  }
}

void expect_same_one_step_at_a_time(const AdaptOptions& options) {
  AdaptOptions one_step = options;
  one_step.max_steps = 1;
  Report report;
  const Field all = adapt_loop(solved(half_disc(), 6), options, report);
  Field field = solved(half_disc(), 6);
  for (std::size_t i = 0; i + 1 < all.adapt_steps.size(); ++i) field = adapt_loop(field, one_step, report);
  EXPECT_EQ(all.elem_order, field.elem_order);
  EXPECT_EQ(all.u, field.u);
  ASSERT_EQ(all.adapt_steps.size(), field.adapt_steps.size());
  for (std::size_t i = 0; i < all.adapt_steps.size(); ++i) {
    EXPECT_EQ(all.adapt_steps[i].elem_order, field.adapt_steps[i].elem_order);
    EXPECT_EQ(all.adapt_steps[i].num_raised, field.adapt_steps[i].num_raised);
    EXPECT_EQ(all.adapt_steps[i].num_lowered, field.adapt_steps[i].num_lowered);
  }
}

TEST(AdaptLoop, OneStepAtATimeIsTheSameAsAllAtOnce) {
  expect_same_one_step_at_a_time({.raise_above = 1e-22, .lower_below = 1e-28, .max_order = 20});
  // Thresholds close together: without its history a step would lower what one before it has raised.
  expect_same_one_step_at_a_time(
      {.policy = AdaptPolicy::paper, .raise_above = 1e-16, .lower_below = 5e-17, .max_order = 12});
}

TEST(AdaptLoop, KeepsADiscontinuousFieldWithinItsOrders) {
  const TriMesh mesh = half_disc();
  Report report;
  const Field start =
      galerkin::solve_laplace(mesh, std::vector<int>(mesh.num_elems(), 11), {.method = FieldMethod::dg}, report);
  const Field field = adapt_loop(start, {.raise_above = 1e-24, .lower_below = 1e-30, .max_order = 20}, report);
  EXPECT_EQ(*std::max_element(field.elem_order.begin(), field.elem_order.end()), 12);
  EXPECT_EQ(field.method, FieldMethod::dg);
}

TEST(AdaptLoop, SaysWhenItStopsEarly) {
  Report report;
  const Field field = adapt_loop(solved(half_disc(), 8), {.policy = AdaptPolicy::paper, .max_steps = 2}, report);
  EXPECT_EQ(field.adapt_steps.size(), 3u);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-ADAPT-001");
  EXPECT_EQ(*std::max_element(field.elem_order.begin(), field.elem_order.end()), 10);
}

TEST(AdaptLoop, RefusesThresholdsThatCross) {
  EXPECT_THROW((AdaptOptions{.raise_above = 1e-12, .lower_below = 1e-10}.validate()), UsageError);
  EXPECT_THROW((AdaptOptions{.min_order = 9, .max_order = 8}.validate()), UsageError);
  EXPECT_NO_THROW(AdaptOptions{}.validate());
}

}  // namespace
}  // namespace quadrille::adapt
