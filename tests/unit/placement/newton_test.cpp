#include "placement/newton.hpp"

#include <gtest/gtest.h>

#include "minimands.hpp"

namespace quadrille::placement {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

TEST(Newton, reaches_the_minimum_of_a_quadratic_function_at_once) {
  const MinimiseOptions options;
  const Minimand f = quadratic(tilted, Vector2d{3, -1});
  Descent descent = descent_from(f, options, Vector2d{2.9, -0.8});
  EXPECT_TRUE(newton(descent));
  EXPECT_TRUE(descent.found.is_converged);
  EXPECT_NEAR((descent.found.x - Vector2d{3, -1}).norm(), 0, 1e-10);
  EXPECT_LE(descent.found.last_step, options.tolerance);
  EXPECT_LE(descent.found.iterations, 4);
}

TEST(Newton, does_not_move_along_a_direction_with_next_to_no_curvature) {
  // A valley along x + y = 1 that falls towards (1, 0), with a curvature of 1e-7 against 2.
  const MinimiseOptions options;
  const Minimand f = quadratic(Matrix2d{{1 + 1e-7, 1}, {1, 1 + 1e-7}}, Vector2d{1, 0});
  Descent descent = descent_from(f, options, Vector2d{0.8, 0.4});
  EXPECT_TRUE(newton(descent));
  EXPECT_NEAR((descent.found.x - Vector2d{0.7, 0.3}).norm(), 0, 1e-6);
}

TEST(Newton, refuses_a_saddle) {
  const MinimiseOptions options;
  const Minimand f = quadratic(Matrix2d{{1, 0}, {0, -1}}, Vector2d::Zero());
  Descent descent = descent_from(f, options, Vector2d{0.01, 0.01});
  EXPECT_FALSE(newton(descent));
  EXPECT_EQ(descent.found.x, (Vector2d{0.01, 0.01}));
  EXPECT_FALSE(descent.found.is_converged);
}

TEST(Newton, takes_whole_steps_only) {
  const MinimiseOptions options;
  Minimand f = quadratic(tilted, Vector2d::Zero());
  f.allowed = [](const VectorXd&, const VectorXd& step) { return step.norm() > 0.1 ? 0.5 : 1.0; };
  Descent far = descent_from(f, options, Vector2d{1, 0});
  EXPECT_FALSE(newton(far));
  EXPECT_EQ(far.found.x, (Vector2d{1, 0}));
  Descent near = descent_from(f, options, Vector2d{0.05, 0});
  EXPECT_TRUE(newton(near));
}

TEST(Newton, stays_where_the_step_leads_out_of_the_function) {
  const MinimiseOptions options;
  const Minimand whole = quadratic(tilted, Vector2d::Zero());
  const Minimand f =
      unbounded([&](const VectorXd& x) { return x[0] > 0.5 ? whole.sample(x) : std::optional<Minimand::Sample>(); });
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  EXPECT_FALSE(newton(descent));
  EXPECT_EQ(descent.found.x, (Vector2d{1, 0}));
}

TEST(Newton, refuses_a_step_to_a_greater_gradient) {
  // The derivative x / (1 + x^2) of ln(1 + x^2) / 2: from 0.9 the step leads to -7.7, where the gradient is smaller;
  // from 0.6 to -0.675, where it is greater.
  const MinimiseOptions options;
  const Minimand f = unbounded([](const VectorXd& x) {
    const double q = 1 + x[0] * x[0];
    return Minimand::Sample{std::log(q) / 2, VectorXd::Constant(1, x[0] / q)};
  });
  Descent descent = descent_from(f, options, VectorXd::Constant(1, 0.6));
  EXPECT_FALSE(newton(descent));
  EXPECT_EQ(descent.found.x[0], 0.6);
}

TEST(Newton, stops_at_the_greatest_number_of_iterations) {
  MinimiseOptions options;
  options.max_iterations = 7;
  const Minimand f = quadratic(tilted, Vector2d::Zero());
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  descent.found.iterations = 7;
  EXPECT_FALSE(newton(descent));
  EXPECT_EQ(descent.found.x, (Vector2d{1, 0}));
}

}  // namespace
}  // namespace quadrille::placement
