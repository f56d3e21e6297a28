#include "placement/descent.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace quadrille::placement
