#include <gtest/gtest.h>

#include "../samples.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawHexMesh, ShowsTheOuterFacesAndSaysWhatTheyBound) {
  const std::string svg = draw_stage(samples::hex_mesh(), {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "2 hexahedra of order 1 in 1 layer"), 1);
  EXPECT_EQ(count(svg, "NOT VALID"), 0);
  EXPECT_EQ(svg, draw_stage(samples::hex_mesh(), {}));
}

TEST(DrawHexMesh, AMeshThatIsNotValidSaysSo) {
  HexMesh mesh = samples::hex_mesh();
  mesh.is_valid = false;
  mesh.elem_jacobian_bound[0] = mesh.least_jacobian_bound = -1;
  EXPECT_EQ(count(draw_stage(mesh, {}), "NOT VALID: 2 hexahedra of order 1 in 1 layer"), 1);
}

/// From above the top is seen, as high as wide; from the side the body is half as high.
TEST(DrawHexMesh, IsSeenFromTheDirectionOfTheOptions) {
  DrawOptions options;
  options.view = ViewDirection(Vec3{0, 0, 1});
  const std::string above = draw_stage(samples::hex_mesh(), options);
  expect_sound(above);
  EXPECT_NE(above, draw_stage(samples::hex_mesh(), {}));
}

}  // namespace
}  // namespace quadrille::draw
