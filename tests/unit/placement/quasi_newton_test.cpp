#include "placement/quasi_newton.hpp"

#include <gtest/gtest.h>

#include "minimands.hpp"

namespace quadrille::placement {
namespace {

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

}  // namespace
}  // namespace quadrille::placement
