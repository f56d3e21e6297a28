#include "cad/periodic_sides.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../samples.hpp"
#include "../support/texts.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "cad/periodic_pairing.hpp"
#include "model/periodic.hpp"

namespace quadrille::cad {
namespace {

CadFace square() {
  CadFace face = samples::face();
  face.curve_names = {"bottom", "right", "top", "left"};
  return face;
}

/// A quarter of an annulus: inner arc, lower end, outer arc, left end. Relative to an origin that is not the centre.
CadFace quarter_annulus(Vec2 origin) {
  const std::vector<Nurbs> loop{
      curve::segment(Vec2{1, 0} - origin, Vec2{2, 0} - origin), curve::circular_arc(-origin, 2, 0, half_pi),
      curve::segment(Vec2{0, 2} - origin, Vec2{0, 1} - origin), curve::circular_arc(-origin, 1, half_pi, 0)};
  CadFace face = hand_made::face({loop}, 2);
  face.origin = origin;
  face.curve_names = {"start", "outer", "end", "inner"};
  return face;
}

CadFace paired(CadFace face, const std::string& option) {
  pair_periodic_sides(face, periodic_options({option}));
  return face;
}

TEST(PeriodicSides, OppositeSidesOfASquareAreATranslation) {
  const CadFace face = paired(square(), "left=right");
  ASSERT_EQ(face.periodic_pairs.size(), 1u);
  EXPECT_EQ(face.periodic_pairs[0].curves, (std::array<int, 2>{3, 1}));
  EXPECT_EQ(face.periodic_pairs[0].angle, 0);
  EXPECT_EQ(face.periodic_pairs[0].shift, (Vec2{1, 0}));
}

/// With the face's origin added, the rotation is about (0, 0).
TEST(PeriodicSides, EndsOfASectorAreARotationInTheCoordinatesOfTheFile) {
  const CadFace face = paired(quarter_annulus({5, 7}), "start=end");
  ASSERT_EQ(face.periodic_pairs.size(), 1u);
  EXPECT_EQ(face.periodic_pairs[0].angle, half_pi);
  EXPECT_LT(norm(face.periodic_pairs[0].shift), 1e-14);
  const PeriodicMotion motion(face.periodic_pairs[0], face.origin);
  EXPECT_EQ(motion.image(face.curves[0].poles.back()), face.curves[2].poles.front()) << "bit for bit";
}

TEST(PeriodicSides, AGivenMotionMustFit) {
  EXPECT_EQ(paired(square(), "left=right:translate=1,0").periodic_pairs.size(), 1u);
  EXPECT_EQ(paired(quarter_annulus({5, 7}), "start=end:rotate=90").periodic_pairs.size(), 1u);
  const std::string wrong = message_of<FormatError>([] { paired(square(), "left=right:translate=1.001,0"); });
  expect_contains(wrong, "the ends of the sides give translate=1,0");
  expect_contains(wrong, "or leave out the motion");
}

TEST(PeriodicSides, OfDifferentShapesAreRefusedWithThePlaceOfTheGreatestDistance) {
  CadFace face = square();
  face.curves[1] = {2, {0, 0, 0, 1, 1, 1}, {{1, 0}, {1.2, 0.5}, {1, 1}}, {1, 1, 1}};
  const std::string text = message_of<FormatError>([&] { paired(face, "left=right"); });
  expect_contains(text, "--periodic left=right: ");
  expect_contains(text, "the point (0, 0.5) of 'left' would be 0.1 (0.071 diameters) away from 'right'");
}

/// The second side, within the tolerance of the fit, becomes the image; what meets its ends moves with it.
TEST(PeriodicSides, TheSecondSideBecomesTheImageOfTheFirst) {
  CadFace face = square();
  const Vec2 off{1, 1 + 5e-10};
  face.curves[1].poles[1] = face.curves[2].poles[0] = face.joints[2].position = off;
  face = paired(face, "left=right");
  const Vec2 image = PeriodicMotion(face.periodic_pairs[0], face.origin).image(face.curves[3].poles.front());
  EXPECT_NE(image, off);
  EXPECT_EQ(face.curves[1].poles[1], image);
  EXPECT_EQ(face.curves[2].poles[0], image);
  EXPECT_EQ(face.joints[2].position, image);
}

TEST(PeriodicSides, AJointThatOneSideLacksIsMadeThere) {
  CadFace face = square();
  split_curve(face, 3, 0.25);  // left, at (0, 0.75)
  face = paired(face, "right=left");
  ASSERT_EQ(face.num_curves(), 6);
  ASSERT_EQ(face.periodic_pairs.size(), 2u);
  EXPECT_EQ(face.curve_names, (std::vector<std::string>{"bottom", "right", "right", "top", "left", "left"}));
  EXPECT_NEAR(face.joints[2].position.y, 0.75, 1e-15);
  for (const PeriodicPair& pair : face.periodic_pairs) EXPECT_EQ(pair.shift, (Vec2{-1, 0}));
}

TEST(PeriodicSides, ASecondPairMayNotHaveASideOfTheFirst) {
  CadFace face = paired(square(), "left=right");
  EXPECT_THROW(paired(face, "top=left"), UsageError);
  EXPECT_EQ(paired(face, "top=bottom").periodic_pairs.size(), 2u);
}

}  // namespace
}  // namespace quadrille::cad
