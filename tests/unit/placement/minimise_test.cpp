#include "placement/minimise.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <cmath>

#include "base/error.hpp"
#include "minimands.hpp"

namespace quadrille::placement {
namespace {

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
    Sample s = rosenbrock(turn.inverse() * Vector2d(x));
    s.gradient = turn * Vector2d(s.gradient);
    return s;
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
