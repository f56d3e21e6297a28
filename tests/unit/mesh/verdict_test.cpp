#include "mesh/verdict.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "quad_row.hpp"

namespace quadrille::mesh {

namespace {

std::string words(const QuadMesh& mesh) { return describe(verdict_of(mesh), mesh.face); }

QuadMesh squares() {
  QuadMesh mesh = quad_row(2, {0, 1, 2, 3}, 1);
  mesh.elem_prescribed_length = {1, 1, 1};
  return mesh;
}

TEST(Verdict, OfSquaresIsGoodInOneWord) {
  EXPECT_EQ(verdict_of(squares()).grade(), Grade::good);
  EXPECT_EQ(words(squares()), "good");
}

TEST(Verdict, NamesTheLeastScaledJacobianAndItsPlace) {
  QuadMesh mesh = squares();
  mesh.face.origin = {10, 20};
  mesh.elem_scaled_jacobian[1] = 0.5;
  EXPECT_EQ(words(mesh), "good") << "at the limit";
  mesh.elem_scaled_jacobian[1] = 0.4;
  EXPECT_EQ(words(mesh), "usable: least scaled Jacobian 0.40 at (11.5, 20.5)");
  mesh.elem_scaled_jacobian[1] = 0.29;
  EXPECT_EQ(verdict_of(mesh).grade(), Grade::poor);
  mesh.elem_scaled_jacobian[1] = -1;
  EXPECT_EQ(verdict_of(mesh).grade(), Grade::poor);
}

/// Squares whose corner at the origin is one of the face with this angle.
QuadMesh with_corner(double angle, bool is_corner) {
  QuadMesh mesh = squares();
  Joint joint;
  joint.interior_angle = angle;
  joint.is_corner = is_corner;
  mesh.face.joints = {joint};
  return mesh;
}

TEST(Verdict, SaysThatASharpCornerAllowsNoBetterElement) {
  const double angle = radians(18);
  QuadMesh mesh = with_corner(angle, true);
  mesh.elem_scaled_jacobian[0] = std::sin(angle);
  EXPECT_EQ(words(mesh),
            "usable: least scaled Jacobian 0.31, that of the face's corner of 18 degrees, which no mesh can better, at "
            "(0, 0)");
  mesh.elem_scaled_jacobian[0] = 0.9 * std::sin(angle);
  EXPECT_EQ(words(mesh), "poor: least scaled Jacobian 0.28 at (0.5, 0.5)") << "the corner allows more";
  mesh = with_corner(angle, false);
  mesh.elem_scaled_jacobian[0] = std::sin(angle);
  EXPECT_EQ(words(mesh), "usable: least scaled Jacobian 0.31 at (0.5, 0.5)");
}

TEST(Verdict, NamesTheLengthsWhereTheResolutionRatioIsHigh) {
  QuadMesh mesh = quad_row(2, {0, 1, 2}, 0.4);
  mesh.elem_prescribed_length = {1, 1};
  EXPECT_EQ(words(mesh),
            "usable: resolution ratio 19.5 near (0.5, 0.2), elements there are 1 by 0.4 prescribed lengths");
  mesh = quad_row(2, {0, 1, 2}, 0.1);
  mesh.elem_prescribed_length = {1, 1};
  EXPECT_EQ(words(mesh).substr(0, 28), "poor: resolution ratio 5000 ");
}

TEST(Verdict, OfAnAreaJumpLeavesOutLayers) {
  QuadMesh mesh = quad_row(1, {0, 1, 1.05, 1.1}, 1);
  mesh.elem_prescribed_length = {1, 0.05, 0.05};
  const Verdict verdict = verdict_of(mesh);
  ASSERT_FALSE(verdict.faults.empty());
  EXPECT_TRUE(std::ranges::any_of(verdict.faults, [](const Fault& f) { return f.limit == Limit::area_jump; }));
  mesh.elem_prescribed_length = {0, 0, 0};
  EXPECT_EQ(words(mesh), "good");
}

TEST(Verdict, TheMostSevereFaultComesFirst) {
  QuadMesh mesh = squares();
  mesh.elem_scaled_jacobian[2] = 0.45;
  mesh.elem_area_jump = {1, 90, 90};
  EXPECT_EQ(words(mesh), "usable: area jump 90 at (1.5, 0.5); least scaled Jacobian 0.45 at (2.5, 0.5)");
  mesh.elem_scaled_jacobian[2] = 0.31;
  EXPECT_EQ(words(mesh), "usable: area jump 90 at (1.5, 0.5); least scaled Jacobian 0.31 at (2.5, 0.5)");
  mesh.elem_scaled_jacobian[2] = 0.301;
  EXPECT_EQ(words(mesh), "usable: least scaled Jacobian 0.30 at (2.5, 0.5); area jump 90 at (1.5, 0.5)");
  mesh.elem_jacobian_bound[0] = -1;
  mesh.is_valid = false;
  EXPECT_EQ(words(mesh).substr(0, 66), "poor: 1 element not proved valid, the worst at (0.5, 0.5); least s");
}

}  // namespace

}  // namespace quadrille::mesh
