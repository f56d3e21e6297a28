#include "field/turn_centres.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

const Loop outline = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

TEST(HolePoints, AreTheCentresOfRoundAndConvexHoles) {
  const CadFace face =
      make_face({outline, hole({1, 1}, 0.3), polygon({{2.5, 2.5}, {2.5, 3.5}, {3.5, 3.5}, {3.5, 2.5}})});
  const std::vector<Vec2> points = hole_points(face);
  ASSERT_EQ(points.size(), 2u);
  EXPECT_NEAR(distance(points[0], {1, 1}), 0, 1e-12);
  EXPECT_NEAR(distance(points[1], {3, 3}), 0, 1e-12);
}

TEST(HolePoints, LieInsideThinAngles) {
  // An L of arms 2 long and w wide: its centroid is outside.
  for (const double w : {0.3, 1e-2, 1e-4}) {
    const CadFace face =
        make_face({outline, polygon({{1, 1}, {1, 3}, {1 + w, 3}, {1 + w, 1 + w}, {3, 1 + w}, {3, 1}})});
    const Vec2 x = hole_points(face).at(0);
    const bool in_upright = x.x > 1 && x.x < 1 + w && x.y > 1 && x.y < 3;
    const bool in_foot = x.y > 1 && x.y < 1 + w && x.x > 1 && x.x < 3;
    EXPECT_TRUE(in_upright || in_foot) << x.x << " " << x.y;
    EXPECT_GT(std::min(std::min(x.x, x.y) - 1, 10.0), 0.2 * w);  // with room on both sides
  }
}

TEST(HolePoints, MoveWithTheFace) {
  const CadFace face = make_face({outline, polygon({{1, 1}, {1.2, 2}, {3, 2.5}, {2, 1}})});
  const Vec2 d = 2.5 * unit(0.6), shift{10, -3}, x = hole_points(face).at(0);
  const Vec2 there = hole_points(moved(face, 2.5, 0.6, shift)).at(0);
  EXPECT_NEAR(distance(there, Vec2{d.x * x.x - d.y * x.y, d.y * x.x + d.x * x.y} + shift), 0, 1e-12);
}

TEST(HolePoints, OfASlitAreTheJointWhoseSectorIsFarthestFromQuarterTurns) {
  EXPECT_EQ(distance(hole_points(bent_slit(0.4)).at(0), {0.5, 0.5}), 0);
  EXPECT_EQ(distance(hole_points(slit_square()).at(0), {0.3, 0.5}), 0);
}

const Loop wide_outline = polygon({{-9, -9}, {9, -9}, {9, 9}, {-9, 9}});

CadFace with_ellipse(double a, double b) {
  Loop loop = hole({0, 0}, 1);
  for (Vec2& pole : loop[0].poles) pole = {a * pole.x, b * pole.y};
  return make_face({wide_outline, loop});
}

TEST(HoleFoci, AreNoneForCirclesAndPolygons) {
  EXPECT_TRUE(hole_foci(make_face({wide_outline, hole({1, 1}, 0.3)})).empty());
  EXPECT_TRUE(hole_foci(make_face({wide_outline, polygon({{0, 0}, {0, 1}, {5, 0}})})).empty());
}

TEST(HoleFoci, OfAThinEllipseAreItsFociWithTwoTurnsEach) {
  for (const double b : {1.0, 0.3, 0.03}) {
    const std::vector<HoleFocus> foci = hole_foci(with_ellipse(4, b));
    ASSERT_EQ(foci.size(), 2u) << b;
    for (const HoleFocus& focus : foci) {
      EXPECT_EQ(focus.turns, 2);
      EXPECT_NEAR(std::abs(focus.position.x), std::sqrt(16 - b * b), 0.1 * b * b);
      EXPECT_NEAR(focus.position.y, 0, 1e-6);
    }
  }
}

TEST(HoleFoci, OfASlotAreInsideItsRoundEnds) {
  const CadFace face =
      make_face({wide_outline,
                 {curve::segment({-2, 0.2}, {2, 0.2}), curve::circular_arc({2, 0}, 0.2, half_pi, -half_pi),
                  curve::segment({2, -0.2}, {-2, -0.2}), curve::circular_arc({-2, 0}, 0.2, 1.5 * pi, half_pi)}});
  const std::vector<HoleFocus> foci = hole_foci(face);
  ASSERT_EQ(foci.size(), 2u);
  for (const HoleFocus& focus : foci) {
    EXPECT_EQ(focus.turns, 2);
    EXPECT_NEAR(std::abs(focus.position.x), 2.1, 1e-3);
    EXPECT_NEAR(focus.position.y, 0, 1e-6);
  }
}

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
