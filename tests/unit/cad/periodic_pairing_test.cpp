#include "cad/periodic_pairing.hpp"

#include <gtest/gtest.h>

#include "../region_samples.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::cad {
namespace {

/// A square with names, and a request for two of its sides.
struct SideFinding : testing::Test {
  CadFace face = samples::face();
  PeriodicRequest request{"left", "right", {}, "--periodic left=right"};

  SideFinding() { face.curve_names = {"bottom", "right", "top", "left"}; }
  PeriodicSide side(const std::string& name) const { return SideFinder(face, request).side(name); }
  std::string refusal(const std::string& name) const {
    return message_of<UsageError>([&] { side(name); });
  }
};

TEST_F(SideFinding, CurvesThatFollowEachOtherAreOnePart) {
  face.curve_names = {"corner", "corner", "top", "left"};
  const PeriodicSide corner = side("corner");
  ASSERT_EQ(corner.size(), 1u);
  EXPECT_EQ(corner[0].curves, (std::vector<int>{0, 1}));
  face.curve_names = {"corner", "right", "top", "corner"};
  EXPECT_EQ(side("corner")[0].curves, (std::vector<int>{3, 0})) << "in the order of the boundary";
}

TEST_F(SideFinding, OthersArePartsOfTheirOwnAndPatternsNameSeveral) {
  face.curve_names = {"side_1", "right", "side_2", "left"};
  const PeriodicSide sides = side("side_*");
  ASSERT_EQ(sides.size(), 2u);
  EXPECT_EQ(sides[0].curves, std::vector<int>{0});
  EXPECT_EQ(sides[1].curves, std::vector<int>{2});
}

TEST_F(SideFinding, UnknownNamesAreRefusedWithThoseThatExist) {
  EXPECT_EQ(refusal("inlet"),
            "--periodic left=right: no curve is named 'inlet'; the names are: bottom, left, right, top");
}

TEST_F(SideFinding, ClosedSidesAreRefused) {
  face.curve_names = {"all", "all", "all", "all"};
  EXPECT_EQ(refusal("all"),
            "--periodic left=right: the curves 'all' at (0, 0) are closed: no motion in the plane maps a closed side "
            "onto another from outside; cut the shape along two lines that repeat each other, and name these");
}

TEST_F(SideFinding, InterfacesAndSidesOfAnotherPairAreRefused) {
  face = samples::two_regions_face();
  expect_contains(refusal("fluid-solid"), "'fluid-solid' at (1, 0) is not on the boundary");
  EXPECT_EQ(refusal("bottom"), "--periodic left=right: 'bottom' is already a side of another periodic pair");
}

TEST_F(SideFinding, BothSidesHaveAsManyPartsAndNoCurveTwice) {
  const SideFinder finder(face, request);
  EXPECT_EQ(message_of<UsageError>([&] {
              finder.require_two_sides({{"a", {0, 1}}}, {{"b", {1}}});
            }),
            "--periodic left=right: 'right' is on both sides");
  EXPECT_EQ(message_of<UsageError>([&] {
              finder.require_two_sides({{"a", {0}}}, {{"b", {1}}, {"b", {3}}});
            }),
            "--periodic left=right: 'left' has 1 part and 'right' has 2 parts that do not follow each other ((0, 0) to "
            "(1, 0); (1, 0) to (1, 1), (0, 1) to (0, 0)): each part needs an image");
  EXPECT_NO_THROW(finder.require_two_sides({{"a", {1}}}, {{"b", {3}}}));
}

TEST(SplitCurve, BothPartsHaveTheNameAndLaterCurvesOtherNumbers) {
  CadFace face = samples::two_regions_face();  // curves 1 and 7 are the interface, (0, 2) and (4, 6) periodic
  const CadFace before = face;
  split_curve(face, 3, 0.25);
  ASSERT_EQ(face.num_curves(), 9);
  EXPECT_EQ(face.loop_offsets, (std::vector<int>{0, 5, 9}));
  EXPECT_EQ(face.curve_names[3], "inlet");
  EXPECT_EQ(face.curve_names[4], "inlet");
  EXPECT_EQ(face.curve_cad_edges[4], before.curve_cad_edges[3]);
  EXPECT_EQ(face.partners, (std::vector<int>{-1, 8, -1, -1, -1, -1, -1, -1, 1}));
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{1, 8}));
  EXPECT_EQ(face.periodic_pairs[1].curves, (std::array<int, 2>{5, 7}));
  EXPECT_EQ(face.curves[4].begin(), 0) << "its parameters begin anew";
  EXPECT_DOUBLE_EQ(face.curves[4].end(), 0.75);
  EXPECT_EQ(face.joints[4].position, (Vec2{0, 0.75}));
  EXPECT_FALSE(face.joints[4].is_corner);
  EXPECT_EQ(face.joints[4].tangent_in, face.joints[4].tangent_out);
}

TEST(SplitCurve, ThePartsOfACurveWithoutAGivenNameHaveNone) {
  CadFace face = samples::face();
  face.unnamed_curves = {1, 3};
  split_curve(face, 1, 0.5);
  EXPECT_EQ(face.unnamed_curves, (std::vector<int>{1, 2, 4}));
}

}  // namespace
}  // namespace quadrille::cad
