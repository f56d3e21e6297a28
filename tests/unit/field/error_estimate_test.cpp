#include "field/error_estimate.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/square_field.hpp"
#include "field/evaluate.hpp"

namespace quadrille::field {
namespace {

// On a square along the axes the boundary data are (1, 0) everywhere.
TEST(BoundaryMisfit, OfTheExactFieldIsNone) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 3), 2, [](Vec2) { return Vec2{1, 0}; });
  for (const double misfit : boundary_misfit(field)) EXPECT_NEAR(misfit, 0, 1e-14);
}

TEST(BoundaryMisfit, IsTheDistanceFromTheDataInElementsOnTheBoundary) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 3), 2, [](Vec2) { return Vec2{1.3, -0.4}; });
  const std::vector<double> misfits = boundary_misfit(field);
  std::vector<double> expected(field.mesh.num_elems(), 0.0);
  for (const BoundaryEdge& edge : field.mesh.boundary_edges) expected[edge.elem] = 0.5;
  for (int e = 0; e < field.mesh.num_elems(); ++e) EXPECT_NEAR(misfits[e], expected[e], 1e-13) << e;
}

Vec2 smooth(Vec2 p) { return {std::exp(p.x) * std::cos(p.y), std::exp(p.x) * std::sin(p.y)}; }

double greatest(const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); }

TEST(ErrorEstimate, FallsWithTheInterpolationErrorOfAnEntireFunction) {
  for (const int order : {3, 5, 7, 9}) {
    const Field field = interpolated_field(square_mesh({0, 0}, 1, 2), order, smooth);
    const FieldEvaluator evaluator(field);
    double error = 0;
    for (int i = 1; i < 20; ++i)
      for (int j = 1; j < 20; ++j) {
        const Vec2 x{i / 20.0 + 0.003, j / 20.0 + 0.001};
        Vec2 value;
        ASSERT_TRUE(evaluator.value_at(x, value));
        error = std::max(error, distance(value, smooth(x)));
      }
    Field without_data = field;  // the function is no guiding field of the square
    without_data.mesh.boundary_edges.clear();
    const double estimate = greatest(error_estimate(without_data));
    EXPECT_GT(estimate, error) << order;
    EXPECT_LT(estimate, 100 * error) << order;
  }
}

TEST(ErrorEstimate, IsRoundingForAConstant) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 6, [](Vec2) { return Vec2{1, 0}; });
  EXPECT_LT(greatest(error_estimate(field)), 1e-13);
}

TEST(ErrorEstimate, SeesAnErrorThatOnlyOneElementHas) {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 3), 6, [](Vec2) { return Vec2{1, 0}; });
  const int rough = 4;
  field.u[field.coef_offsets[rough + 1] - 1] = 1e-3;  // a mode of the highest degree
  const std::vector<double> errors = error_estimate(field);
  EXPECT_GT(errors[rough], 1e-4);
  for (int e = 0; e < field.mesh.num_elems(); ++e) {
    if (e == rough) continue;
    EXPECT_LT(errors[e], 0.2 * errors[rough]);  // the others hear of it
    EXPECT_GT(errors[e], 1e-7);
  }
}

TEST(ErrorEstimate, SeesWrongBoundaryData) {
  // The square's tangents ask for (1, 0).
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 2), 4, [](Vec2) { return Vec2{1, 1e-3}; });
  for (const BoundaryEdge& edge : field.mesh.boundary_edges) {
    EXPECT_NEAR(boundary_misfit(field)[edge.elem], 1e-3, 1e-12);
    EXPECT_GE(error_estimate(field)[edge.elem], 1e-3 * (1 - 1e-9));
  }
}

TEST(PositionError, IsTheGreatestStepOfNewtonForAnErrorOfThatSize) {
  EXPECT_NEAR(position_error({2, 0, 0, 0.5}, 1e-3), 2e-3, 1e-15);
  const double c = std::cos(0.3), s = std::sin(0.3);
  EXPECT_NEAR(position_error({4 * c, -4 * s, s, c}, 1e-3), 1e-3, 1e-15);
  EXPECT_TRUE(std::isinf(position_error({1, 1, 1, 1}, 1e-3)));
}

}  // namespace
}  // namespace quadrille::field
