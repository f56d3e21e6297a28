#include "placement/clearance.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

TEST(SignedClearance, is_the_distance_to_the_boundary_with_the_side_as_sign) {
  EXPECT_NEAR(signed_clearance(square(), {0.3, 0.4}), 0.3, 1e-14);
  EXPECT_NEAR(signed_clearance(square(), {1.3, 0.4}), -0.3, 1e-14);
  EXPECT_NEAR(signed_clearance(annulus(), {0.6, 0}), 0.1, 1e-14);
  EXPECT_NEAR(signed_clearance(annulus(), {0.1, 0}), -0.4, 1e-14);
  EXPECT_NEAR(signed_clearance(annulus(), {0, 1.5}), -0.5, 1e-14);
}

TEST(SignedClearance, near_corners_goes_by_their_sector) {
  EXPECT_NEAR(signed_clearance(square(), {-0.3, -0.4}), -0.5, 1e-14);
  EXPECT_NEAR(signed_clearance(l_shape(), {0.97, 0.96}), 0.05, 1e-14);  // the reflex corner at (1, 1), from inside
  EXPECT_NEAR(signed_clearance(l_shape(), {1.1, 1.2}), -0.1, 1e-14);
}

TEST(SignedClearance, is_positive_on_both_sides_of_a_slit) {
  for (const double side : {1.0, -1.0}) {
    EXPECT_NEAR(signed_clearance(slit_square(), {0.5, 0.5 + 0.1 * side}), 0.1, 1e-14);
    EXPECT_NEAR(signed_clearance(open_slit(), {0.9, 0.5 + 0.05 * side}), 0.05, 1e-14);
  }
}

TEST(ClearanceAlong, is_the_first_part_inside) {
  EXPECT_NEAR(clearance_along(square(), {0.25, 0.5}, {1, 0}), 0.75, 1e-12);
  EXPECT_NEAR(clearance_along(square(), {0.25, 0.5}, {-1, 0}), 0.25, 1e-12);
  EXPECT_NEAR(clearance_along(annulus(), {0, 0}, unit(1.0)), 0.5, 1e-12);
  EXPECT_NEAR(clearance_along(annulus(), {-2, 0}, {1, 0}), 0.5, 1e-12);
  EXPECT_EQ(clearance_along(square(), {2, 0.5}, {1, 0}), 0);
  EXPECT_NEAR(clearance_along(slit_square(), {0.5, 0.25}, {0, 1}), 0.25, 1e-12);
}

TEST(NearestFeet, are_all_that_are_equally_near) {
  EXPECT_EQ(nearest_feet(square(), {0.5, 0.5}).size(), 4u);
  EXPECT_EQ(nearest_feet(square(), {0.5, 0.4}).size(), 1u);
}

}  // namespace
}  // namespace quadrille::placement
