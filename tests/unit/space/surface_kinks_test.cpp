#include "space/surface_kinks.hpp"

#include <gtest/gtest.h>

#include "grid_face.hpp"

namespace quadrille::space {

namespace {

TEST(SurfaceKinks, a_ridge_inside_the_face_is_one) {
  for (const int n : {2, 3}) {  // the triangles end there, or cross it
    const auto kink = kink_inside(grid_face(roof(0.3), n), 0.1);
    ASSERT_TRUE(kink.has_value());
    EXPECT_TRUE(kink->is_u);
    EXPECT_EQ(kink->parameter, 0.5);
    EXPECT_NEAR(kink->angle, 0.3, 1e-12);
  }
}

TEST(SurfaceKinks, a_lesser_ridge_and_one_at_the_end_of_the_face_are_none) {
  EXPECT_FALSE(kink_inside(grid_face(roof(0.3), 2), 0.4).has_value());
  RawSpaceFace raw = grid_face(roof(0.3), 2);
  raw.triangles = {raw.triangles[0], raw.triangles[1], raw.triangles[4], raw.triangles[5]};
  raw.triangle_uv = {raw.triangle_uv[0], raw.triangle_uv[1], raw.triangle_uv[4], raw.triangle_uv[5]};
  EXPECT_FALSE(kink_inside(raw, 0.1).has_value());
}

}  // namespace

}  // namespace quadrille::space
