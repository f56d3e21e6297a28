#include "field/mirror_images.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

void expect_image(const MirrorImage& image, Vec2 position, int loop) {
  EXPECT_NEAR(distance(image.position, position), 0, 1e-12);
  EXPECT_EQ(image.loop, loop);
}

TEST(MirrorImages, InStraightSidesAreReflections) {
  const std::vector<MirrorImage> images = MirrorImages(square()).of({0.1, 0.2});
  ASSERT_EQ(images.size(), 2u);  // bottom, left; the other sides are too far
  expect_image(images[0], {0.1, -0.2}, 0);
  expect_image(images[1], {-0.1, 0.2}, 0);
}

TEST(MirrorImages, InCirclesAreInversions) {
  const CadFace face = make_face({circle({0, 0}, 4), hole({1, 0}, 0.5)});
  for (const double depth : {0.3, 1e-3, 1e-8}) {
    const Vec2 outer = (4 - depth) * unit(2.0);
    std::vector<MirrorImage> images = MirrorImages(face).of(outer);
    ASSERT_EQ(images.size(), 1u);
    expect_image(images[0], outer * (16 / norm2(outer)), 0);

    const Vec2 arm = (0.5 + depth) * unit(1.0);
    images = MirrorImages(face).of(Vec2{1, 0} + arm);
    ASSERT_EQ(images.size(), 1u);
    expect_image(images[0], Vec2{1, 0} + arm * (0.25 / norm2(arm)), 1);
  }
}

TEST(MirrorImages, AreNoneFarFromTheBoundaryOrBeyondASlit) {
  EXPECT_TRUE(MirrorImages(make_face({circle({0, 0}, 1)})).of({0.01, 0}).empty());
  // A slit 0.02 wide: the image of a point 0.1 from it would be inside the domain again.
  const CadFace slit =
      make_face({polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}}), polygon({{1, 2}, {1, 2.02}, {3, 2.02}, {3, 2}})});
  EXPECT_TRUE(MirrorImages(slit).of({2, 1.9}).empty());
  ASSERT_EQ(MirrorImages(slit).of({2, 1.995}).size(), 1u);
  expect_image(MirrorImages(slit).of({2, 1.995})[0], {2, 2.005}, 1);
}

TEST(MirrorImages, AreNoneAboutACorner) {
  // The foot is the corner (1.4, 2), and right below the normal of the side from there to (2, 1.2).
  const CadFace face = make_face({polygon({{0, 0}, {5, 0}, {5, 4}, {0, 4}}), polygon({{1, 1}, {1.4, 2}, {2, 1.2}})});
  for (const double off : {-1e-3, 0.0, 1e-3}) {
    for (const MirrorImage& image : MirrorImages(face).of({2.2 - 0.6 * off, 2.6 + 0.8 * off})) EXPECT_EQ(image.loop, 0);
  }
}

TEST(MirrorImages, CountOnceAtASmoothJoint) {
  const CadFace face = make_face({polygon({{-2, 0}, {0, 0}, {2, 0}, {2, 3}, {-2, 3}})});
  EXPECT_EQ(MirrorImages(face).of({0, 0.3}).size(), 1u);
}

}  // namespace
}  // namespace quadrille::field
