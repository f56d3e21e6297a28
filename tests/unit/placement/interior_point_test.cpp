#include "placement/interior_point.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "placement/clearance.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

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
  EXPECT_NEAR(signed_clearance(face, most_interior_point(face, {{{0, 0}, 0, false}})), 0.005, 1e-4);
}

}  // namespace
}  // namespace quadrille::placement
