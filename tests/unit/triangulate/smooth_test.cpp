#include "triangulate/smooth.hpp"

#include <gtest/gtest.h>

#include "base/angle.hpp"

namespace quadrille::triangulate {
namespace {

TEST(Smooth, ShapeIsOneForEquilateralZeroForFlatAndChangesSignWithOrientation) {
  EXPECT_NEAR(triangle_shape({0, 0}, {1, 0}, unit(pi / 3)), 1, 1e-15);
  EXPECT_EQ(triangle_shape({0, 0}, {1, 0}, {2, 0}), 0);
  EXPECT_LT(triangle_shape({0, 0}, {0, 1}, {1, 0}), 0);
}

/// A hexagon with its centre out of place.
Draft hexagon() {
  Draft draft;
  for (int k = 0; k < 6; ++k) draft.add_vertex(unit(k * pi / 3));
  const int centre = draft.add_vertex({0.5, 0.2});
  for (int k = 0; k < 6; ++k) draft.add_triangle(k, (k + 1) % 6, centre, -1);
  return draft;
}

TEST(Smooth, AFreeVertexGoesToTheMiddle) {
  Draft draft = hexagon();
  smooth(draft, {0, 0, 0, 0, 0, 0, 1});
  EXPECT_NEAR(norm(draft.vertices[6]), 0, 1e-12);
}

TEST(Smooth, OtherVerticesStay) {
  Draft draft = hexagon();
  const auto before = draft.vertices;
  smooth(draft, {0, 0, 0, 0, 0, 0, 0});
  EXPECT_EQ(draft.vertices, before);
}

}  // namespace
}  // namespace quadrille::triangulate
