#include "curve/face_position.hpp"

#include <gtest/gtest.h>

#include <string>

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

}  // namespace
}  // namespace quadrille::curve
