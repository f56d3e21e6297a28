#include "couple/interface_corner.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::couple {
namespace {

using namespace testing_faces;

/// A square with a slit from the middle of its right side to the left and then up, or on to the left.
CadFace bent_slit(Vec2 end) {
  CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 2}, {2, 2}, end, {2, 2}, {4, 2}, {4, 4}, {0, 4}})});
  pair_sides(face, 2, 5);
  pair_sides(face, 3, 4);
  return face;
}

TEST(InterfaceCorner, IsWhereASlitTurns) {
  const auto found = sharpest_interface_corner(bent_slit({2, 3}));
  ASSERT_TRUE(found);
  EXPECT_EQ(found->joint, 3);
  EXPECT_NEAR(degrees(found->turn), 90, 1e-9);
}

TEST(InterfaceCorner, IsNoneAtEndsAndInSmoothCurves) {
  EXPECT_FALSE(sharpest_interface_corner(bent_slit({1, 2})));
  EXPECT_FALSE(sharpest_interface_corner(bent_slit({1, 2.5})));
  EXPECT_FALSE(sharpest_interface_corner(slit_square()));
  EXPECT_FALSE(sharpest_interface_corner(square())) << "its corners belong to no embedded curve";
}

}  // namespace
}  // namespace quadrille::couple
