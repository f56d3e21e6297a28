#include "field/boundary_misfit.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"

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

}  // namespace
}  // namespace quadrille::field
