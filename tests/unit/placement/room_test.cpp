#include "placement/room.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

TEST(SignedRoom, is_the_distance_to_the_boundary_with_the_side_as_sign) {
  EXPECT_NEAR(signed_room(square(), {0.3, 0.4}), 0.3, 1e-14);
  EXPECT_NEAR(signed_room(square(), {1.3, 0.4}), -0.3, 1e-14);
  EXPECT_NEAR(signed_room(annulus(), {0.6, 0}), 0.1, 1e-14);
  EXPECT_NEAR(signed_room(annulus(), {0.1, 0}), -0.4, 1e-14);
  EXPECT_NEAR(signed_room(annulus(), {0, 1.5}), -0.5, 1e-14);
}

TEST(SignedRoom, near_corners_goes_by_their_sector) {
  EXPECT_NEAR(signed_room(square(), {-0.3, -0.4}), -0.5, 1e-14);
  EXPECT_NEAR(signed_room(l_shape(), {0.97, 0.96}), 0.05, 1e-14);  // the reflex corner at (1, 1), from inside
  EXPECT_NEAR(signed_room(l_shape(), {1.1, 1.2}), -0.1, 1e-14);
}

TEST(RoomAlong, is_the_first_stretch_inside) {
  EXPECT_NEAR(room_along(square(), {0.25, 0.5}, {1, 0}), 0.75, 1e-12);
  EXPECT_NEAR(room_along(square(), {0.25, 0.5}, {-1, 0}), 0.25, 1e-12);
  EXPECT_NEAR(room_along(annulus(), {0, 0}, unit(1.0)), 0.5, 1e-12);
  EXPECT_NEAR(room_along(annulus(), {-2, 0}, {1, 0}), 0.5, 1e-12);
  EXPECT_EQ(room_along(square(), {2, 0.5}, {1, 0}), 0);
}

TEST(NearestFeet, are_all_that_are_equally_near) {
  EXPECT_EQ(nearest_feet(square(), {0.5, 0.5}).size(), 4u);
  EXPECT_EQ(nearest_feet(square(), {0.5, 0.4}).size(), 1u);
}

TEST(MostInteriorPoint, of_symmetric_faces_is_the_centre) {
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {3, 1}, {0, 1}})});
  EXPECT_LT(distance(most_interior_point(face, {{{0, 0}, 0, false}}), {1.5, 0.5}), 1e-9);
  EXPECT_LT(distance(most_interior_point(half_disc(), {{{0, 0}, 0, false}}),
                     most_interior_point(half_disc(), curve::symmetries(half_disc()))),
            1e-9);
}

TEST(MostInteriorPoint, stays_on_the_mirror_axis_and_moves_with_the_face) {
  const Vec2 on_axis = most_interior_point(l_shape(), curve::symmetries(l_shape()));
  EXPECT_NEAR(on_axis.x, on_axis.y, 1e-12);
  const CadFace face = make_face({polygon({{0, 0}, {3, 0}, {2, 1}, {0, 1.3}})});
  const CadFace image = moved(face, 5, 0.7, {3, 1}, true);
  const Vec2 x = most_interior_point(face, curve::symmetries(face));
  const Vec2 expected = 5 * curve::Isometry{{0, 0}, 0.7, true}.turned(x) + Vec2{3, 1};
  EXPECT_LT(distance(most_interior_point(image, curve::symmetries(image)), expected), 1e-9 * image.diameter);
}

TEST(MostInteriorPoint, of_a_thin_face_lies_in_its_middle_line) {
  const CadFace face = make_face({polygon({{0, 0}, {1, 0}, {1.002, 0.01}, {0, 0.01}})});
  EXPECT_NEAR(signed_room(face, most_interior_point(face, {{{0, 0}, 0, false}})), 0.005, 1e-4);
}

}  // namespace
}  // namespace quadrille::placement
