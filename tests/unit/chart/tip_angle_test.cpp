#include "chart/tip_angle.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "space_faces.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

TEST(TipAngle, IsThatOfTheUnrolledConeAtItsApexAndNothingElsewhere) {
  const double angle = 2;
  const SpaceFace face = tests::cone_with_apex(angle);
  int num_tips = 0;
  for (int c = 0; c < static_cast<int>(face.curves.size()); ++c) {
    const Vec3 x = face.curves[c].poles.front();
    const Vec2 uv = surface::project(face.surface, x, {0.5, 0.5}).uv;
    const std::optional<double> found = tip_angle(face, c, uv, 1);
    const bool is_apex = norm(x) < 1e-12;
    EXPECT_EQ(found.has_value(), is_apex);
    EXPECT_NEAR(found.value_or(0), is_apex ? angle / std::sqrt(2) : 0, 1e-6);
    num_tips += is_apex;
  }
  EXPECT_EQ(num_tips, 1);
}

}  // namespace
}  // namespace quadrille::chart
