#include "curve/named_places.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../chart_samples.hpp"
#include "../hand_made.hpp"
#include "../support/region_graphs.hpp"
#include "base/error.hpp"

namespace quadrille::curve {

namespace {

// A face in the plane x = 7 of the model's space, its x axis along y, its y axis along z.
CadFace upright_face() {
  CadFace face;
  face.plane_origin = {7, 1, 2};
  face.plane_x = {0, 1, 0};
  face.plane_y = {0, 0, 1};
  face.origin = {10, 20};
  face.diameter = 4;
  return face;
}

TEST(FacePosition, OfTwoCoordinatesIsRelativeToTheOrigin) {
  EXPECT_EQ(face_position(upright_face(), {11, 18}, "--node"), (Vec2{1, -2}));
}

TEST(FacePosition, OfThreeCoordinatesIsItsPlaceInThePlane) {
  EXPECT_EQ(face_position(upright_face(), {7, 1 + 11, 2 + 18}, "--node"), (Vec2{1, -2}));
  EXPECT_EQ(face_position(upright_face(), {7.003, 1 + 11, 2 + 18}, "--node"), (Vec2{1, -2}));
}

TEST(FacePosition, RefusesWhatLiesOffThePlane) {
  try {
    face_position(upright_face(), {7.5, 12, 20}, "--node 3");
    FAIL();
  } catch (const FormatError& error) {
    EXPECT_EQ(std::string(error.what()), "--node 3: (7.5, 12, 20) lies 0.5 off the plane of the face");
  }
}

TEST(CurveDistances, OfACurvedFaceAreThoseInSpace) {
  const CadFace face = samples::sphere_face();
  const std::vector<double> distances = curve_distances(face, {0, 0, 2}, "--name");
  ASSERT_EQ(distances.size(), 4u);
  EXPECT_NEAR(distances[0], 1, 1e-12) << "from the pole";
  EXPECT_NEAR(distances[1], distance(Vec3{0.8, 0, 0.6}, Vec3{0, 0, 2}), 1e-9);
  EXPECT_THROW(curve_distances(face, {0, 0}, "--name"), FormatError);
  EXPECT_NEAR(curve_distances(samples::face(), {0.5, -3}, "")[0], 3 - samples::face().origin.y, 1e-12);
}

TEST(NamedCurves, NamesGoBeforeNumbers) {
  CadFace face = hand_made::unit_square().face;
  face.curve_names = {"wall", "0", "wall", "out"};
  EXPECT_EQ(named_curves(face, "wall", "--wall"), (std::vector<int>{0, 2}));
  EXPECT_EQ(named_curves(face, "0", "--wall"), std::vector<int>{1});
  EXPECT_EQ(named_curves(face, "3", "--wall"), std::vector<int>{3});
  try {
    named_curves(face, "wal", "--wall");
    FAIL() << "an unknown name was accepted";
  } catch (const UsageError& error) {
    for (const char* known :
         {"--wall: there is no boundary \"wal\" (did you mean wall?); the names are ", "out", "0 to 3"})
      EXPECT_NE(std::string(error.what()).find(known), std::string::npos) << error.what();
  }
}

TEST(NamedCurves, ARegionPicksOneSideOfAnInterface) {
  CadFace face = region_graphs::two_squares().face;
  face.region_names = {"fluid", "solid"};
  face.curve_names[1] = face.curve_names[7] = "wet";
  EXPECT_EQ(named_curves(face, "wet", "--wall"), (std::vector<int>{1, 7}));
  EXPECT_EQ(named_curves(face, "wet@fluid", "--wall"), std::vector<int>{1});
  EXPECT_EQ(named_curves(face, "wet@1", "--wall"), std::vector<int>{7});
  EXPECT_EQ(named_curves(face, "0@fluid", "--wall"), std::vector<int>{0});
  const auto refusal = [&](const char* name) {
    try {
      named_curves(face, name, "--wall");
    } catch (const UsageError& error) {
      return std::string(error.what());
    }
    return std::string("accepted");
  };
  EXPECT_EQ(refusal("wet@fluod"),
            "--wall: the boundary \"wet\" does not belong to a region \"fluod\" (did you mean fluid?); the regions are "
            "fluid, solid");
  EXPECT_EQ(refusal("0@solid").substr(0, 52), "--wall: the boundary \"0\" does not belong to a region");
  EXPECT_EQ(refusal("dry@fluid").substr(0, 39), "--wall: there is no boundary \"dry\"; the");
  face.curve_names[0] = "wet@fluid";
  EXPECT_EQ(named_curves(face, "wet@fluid", "--wall"), std::vector<int>{0}) << "a name may contain an @";
}

TEST(NamedCurves, ANumberIsThatOfTheNameMadeFromIt) {
  CadFace face = hand_made::unit_square().face;
  face.curve_names = {"curve_0", "curve_3_offset", "curve_3", "curve_1"};
  face.unnamed_curves = {0, 1, 2, 3};
  EXPECT_EQ(named_curves(face, "3", "--wall"), std::vector<int>{2});
  EXPECT_EQ(named_curves(face, "2", "--wall"), std::vector<int>{2}) << "no curve has the name curve_2";
}

}  // namespace

}  // namespace quadrille::curve
