#include "placement/minimise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"
#include "minimands.hpp"

namespace quadrille::placement {
namespace {

using Eigen::Matrix2d;
using Eigen::Vector2d;
using Eigen::VectorXd;

/// Exists for low < x[0] < high only.
Minimand between(double low, double high) {
  const Minimand whole = quadratic(tilted, Vector2d::Zero());
  return unbounded([=](const VectorXd& x) {
    return low < x[0] && x[0] < high ? whole.sample(x) : std::optional<Minimand::Sample>();
  });
}

TEST(Descent, counts_its_evaluations_and_stands_where_it_accepted) {
  const MinimiseOptions options;
  const Minimand f = quadratic(tilted, Vector2d::Zero());
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  const Vector2d step{-0.5, 0};
  const auto next = evaluate(descent, descent.found.x + step);
  ASSERT_TRUE(next);
  EXPECT_EQ(descent.found.evaluations, 1);
  EXPECT_EQ(descent.found.x, (Vector2d{1, 0}));
  accept(descent, *next, step);
  EXPECT_EQ(descent.found.x, (Vector2d{0.5, 0}));
  EXPECT_EQ(descent.here.gradient, (Vector2d{1, 0.5}));
}

TEST(HessianModes, of_a_quadratic_function_are_its_curvatures) {
  const MinimiseOptions options;
  const Minimand f = quadratic(tilted, Vector2d{3, -1});
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  const auto modes = hessian_modes(descent);
  ASSERT_TRUE(modes);
  EXPECT_NEAR(modes->solver.eigenvalues()[0], 1, 1e-9);
  EXPECT_NEAR(modes->solver.eigenvalues()[1], 3, 1e-9);
  EXPECT_NEAR(std::abs(modes->solver.eigenvectors().col(1).dot(Vector2d{1, 1})), std::sqrt(2.0), 1e-9);
  EXPECT_EQ(descent.found.least_curvature, modes->least());
  EXPECT_EQ(descent.found.evaluations, 2);
}

TEST(HessianModes, are_found_on_the_side_where_the_function_exists) {
  const MinimiseOptions options;
  const Minimand f = between(0, 1 + 1e-7);
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  const auto modes = hessian_modes(descent);
  ASSERT_TRUE(modes);
  EXPECT_NEAR(modes->least(), 1, 1e-9);
  EXPECT_EQ(descent.found.evaluations, 3);
  const Minimand narrow = between(1 - 1e-7, 1 + 1e-7);
  Descent stuck = descent_from(narrow, options, Vector2d{1, 0});
  EXPECT_FALSE(hessian_modes(stuck));
}

TEST(HessianModes, are_decided_where_no_curvature_may_be_of_either_sign) {
  const MinimiseOptions options;
  const auto is_decided = [&](double curvature, const Vector2d& x) {
    const Minimand f = quadratic(Matrix2d{{1, 0}, {0, curvature}}, Vector2d::Zero());
    Descent descent = descent_from(f, options, x);
    return hessian_modes(descent)->are_decided();
  };
  EXPECT_TRUE(is_decided(0.1, {0.01, 0}));
  EXPECT_FALSE(is_decided(0.1, {0.05, 0}));  // a gradient of 0.05 may make a flat direction appear to bend by 0.15
  EXPECT_TRUE(is_decided(0, {0.05, 0}));
  EXPECT_TRUE(is_decided(1e-6, {0, 0}));
  EXPECT_FALSE(is_decided(-0.1, {0, 0}));
}

using Eigen::MatrixXd;
using Eigen::Vector2d;
using Eigen::VectorXd;

TEST(QuasiNewton, makes_every_entry_of_the_gradient_small) {
  const MinimiseOptions options;
  const VectorXd curvatures{{1, 10, 100, 1000}}, centre{{1, -2, 3, -4}};
  const Minimand f = quadratic(curvatures.asDiagonal(), centre);
  Descent descent = descent_from(f, options, VectorXd::Zero(4));
  EXPECT_TRUE(quasi_newton(descent, 1e-8, true));
  EXPECT_LE(descent.here.gradient.lpNorm<Eigen::Infinity>(), 1e-8);
  EXPECT_LE((descent.found.x - centre).norm(), 2e-8);
  EXPECT_LE(descent.found.iterations, 40);
}

TEST(QuasiNewton, from_the_hessian_takes_one_step_in_a_quadratic_function) {
  const MinimiseOptions options;
  const Minimand f = quadratic(tilted, Vector2d{3, -1});
  Descent descent = descent_from(f, options, Vector2d{0, 0});
  EXPECT_TRUE(quasi_newton(descent, 1e-6, false));
  EXPECT_EQ(descent.found.iterations, 1);
  Descent slower = descent_from(f, options, Vector2d{0, 0});
  EXPECT_TRUE(quasi_newton(slower, 1e-6, true));
  EXPECT_GT(slower.found.iterations, 1);
}

TEST(QuasiNewton, where_the_gradient_is_small_already_nothing_is_evaluated) {
  const MinimiseOptions options;
  const Minimand f = quadratic(tilted, Vector2d::Zero());
  Descent descent = descent_from(f, options, Vector2d{1e-3, 0});
  EXPECT_TRUE(quasi_newton(descent, 1e-2, true));
  EXPECT_EQ(descent.found.evaluations, 0);
}

TEST(QuasiNewton, leaves_a_saddle_downwards) {
  // x^2 / 2 + (y^2 - 1)^2 / 4: the curvature in y is -1 at y = 0.
  const MinimiseOptions options;
  const Minimand f = unbounded([](const VectorXd& x) {
    const double excess = x[1] * x[1] - 1;
    return Minimand::Sample{x[0] * x[0] / 2 + excess * excess / 4, Vector2d{x[0], excess * x[1]}};
  });
  for (const bool from_identity : {true, false}) {
    Descent descent = descent_from(f, options, Vector2d{0.5, 0.1});
    EXPECT_TRUE(quasi_newton(descent, 1e-8, from_identity));
    EXPECT_NEAR((descent.found.x - Vector2d{0, 1}).norm(), 0, 1e-7);
  }
}

TEST(QuasiNewton, gives_up_where_no_step_leads_down) {
  // The gradient has the wrong sign.
  const MinimiseOptions options;
  const Minimand f = unbounded([](const VectorXd& x) { return Minimand::Sample{x.squaredNorm() / 2, -x}; });
  Descent descent = descent_from(f, options, Vector2d{1, 0});
  EXPECT_FALSE(quasi_newton(descent, 1e-8, true));
  EXPECT_EQ(descent.found.x, (Vector2d{1, 0}));
  EXPECT_EQ(descent.found.evaluations, 40);
}

TEST(QuasiNewton, halves_a_step_that_leads_out_of_the_function) {
  // x - 2 ln x from 1/4: the first step, 7, is allowed; it leads past 4, where the function ends, until halved.
  const MinimiseOptions options;
  const Minimand f = unbounded([](const VectorXd& x) -> std::optional<Minimand::Sample> {
    if (x[0] <= 0 || x[0] >= 4) return std::nullopt;
    return Minimand::Sample{x[0] - 2 * std::log(x[0]), VectorXd::Constant(1, 1 - 2 / x[0])};
  });
  Descent descent = descent_from(f, options, VectorXd::Constant(1, 0.25));
  EXPECT_TRUE(quasi_newton(descent, 1e-8, true));
  EXPECT_NEAR(descent.found.x[0], 2, 1e-7);
}

TEST(QuasiNewton, stops_at_the_greatest_number_of_iterations) {
  MinimiseOptions options;
  options.max_iterations = 2;
  const Minimand f = quadratic(VectorXd{{1, 10, 100}}.asDiagonal(), VectorXd::Ones(3));
  Descent descent = descent_from(f, options, VectorXd::Zero(3));
  EXPECT_FALSE(quasi_newton(descent, 1e-12, true));
}

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

using Eigen::Vector2d;
using Eigen::VectorXd;
using Sample = Minimand::Sample;

Sample rosenbrock(const VectorXd& x) {
  const double a = 1 - x[0], b = x[1] - x[0] * x[0];
  return {a * a + 100 * b * b, Vector2d{-2 * a - 400 * x[0] * b, 200 * b}};
}

Sample ring(const VectorXd& x) {
  const double excess = x.squaredNorm() - 1;
  return {excess * excess, 4 * excess * x};
}

TEST(Minimise, follows_a_bent_valley) {
  const Minimum found = minimise(unbounded(rosenbrock), Vector2d{-1.2, 1}, {});
  EXPECT_TRUE(found.is_converged);
  EXPECT_NEAR((found.x - Vector2d{1, 1}).norm(), 0, 1e-10);
  EXPECT_LE(found.last_step, 1e-10);
  EXPECT_GT(found.least_curvature, 0);
}

TEST(Minimise, does_not_walk_where_it_is_flat) {
  for (const double angle : {0.0, 0.3, 2.0}) {
    const Vector2d direction{std::cos(angle), std::sin(angle)};
    Minimand f = unbounded(ring);
    f.allowed = [](const VectorXd&, const VectorXd& step) { return std::min(1.0, 0.3 / step.norm()); };
    const Minimum found = minimise(f, 1.7 * direction, {});
    EXPECT_TRUE(found.is_converged);
    EXPECT_NEAR(found.x.norm(), 1, 1e-10);
    EXPECT_NEAR((found.x - direction).norm(), 0, 1e-7);  // of the error of a one-sided difference
    EXPECT_NEAR(found.least_curvature, 0, 1e-4);
  }
}

TEST(Minimise, turns_with_the_function) {
  const Eigen::Rotation2D<double> turn(0.7);
  const auto turned = [&](const VectorXd& x) {
    const Sample s = rosenbrock(turn.inverse() * Vector2d(x));
    return Sample{s.value, turn * Vector2d(s.gradient)};
  };
  const Minimum found = minimise(unbounded(turned), turn * Vector2d{-1.2, 1}, {});
  EXPECT_NEAR((found.x - turn * Vector2d{1, 1}).norm(), 0, 1e-10);
}

TEST(Minimise, turns_back_from_where_the_function_does_not_exist) {
  const auto barrier = [](const VectorXd& x) -> std::optional<Sample> {
    if (x[0] <= 0 || x[1] <= 0) return std::nullopt;
    return Sample{x[0] - std::log(x[0]) + 50 * x[1] - std::log(x[1]), Vector2d{1 - 1 / x[0], 50 - 1 / x[1]}};
  };
  const Minimum found = minimise(unbounded(barrier), Vector2d{0.01, 3}, {});
  EXPECT_TRUE(found.is_converged);
  EXPECT_NEAR((found.x - Vector2d{1, 0.02}).norm(), 0, 1e-10);
}

TEST(Minimise, takes_no_longer_steps_than_allowed) {
  Minimand f = unbounded(rosenbrock);
  f.allowed = [](const VectorXd&, const VectorXd& step) { return std::min(1.0, 0.05 / step.norm()); };
  Vector2d last{-1.2, 1};
  double longest = 0;
  f.sample = [&](const VectorXd& x) {
    longest = std::max(longest, (x - last).norm());
    last = x;
    return rosenbrock(x);
  };
  EXPECT_TRUE(minimise(f, last, {}).is_converged);
  EXPECT_LE(longest, 0.05 * (1 + 1e-12));
}

TEST(Minimise, values_that_are_rough_do_not_spoil_the_end) {
  const auto rough = [](const VectorXd& x) {
    Sample s = rosenbrock(x);
    s.value += 1e-10 * std::sin(1e12 * x[0]);
    return s;
  };
  const Minimum found = minimise(unbounded(rough), Vector2d{-1.2, 1}, {});
  EXPECT_TRUE(found.is_converged);
  EXPECT_NEAR((found.x - Vector2d{1, 1}).norm(), 0, 1e-10);
}

TEST(Minimise, says_so_when_it_is_not_done) {
  MinimiseOptions options;
  options.max_iterations = 3;
  EXPECT_FALSE(minimise(unbounded(rosenbrock), Vector2d{-1.2, 1}, options).is_converged);
}

TEST(Minimise, without_variables_is_done) { EXPECT_TRUE(minimise(unbounded(ring), VectorXd(0), {}).is_converged); }

TEST(Minimise, wants_a_start_where_the_function_exists) {
  const auto nowhere = [](const VectorXd&) { return std::optional<Sample>(); };
  EXPECT_THROW(minimise(unbounded(nowhere), Vector2d{0, 0}, {}), Defect);
}

}  // namespace
}  // namespace quadrille::placement
