#include "field/corner_terms.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

const PhaseNodes right_corners{{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}};
const PhaseNodes one_smooth_corner{{}, {{0, 1}, {1, 1}, {2, 1}, {3, 2}}, {}};

TEST(CornerTerms, AssignApexesToTheCornersWhereTheDataJump) {
  EXPECT_EQ(corner_terms(square(), right_corners).apex2corner_angle, (std::vector<int>{-1, -1, -1, -1}));
  EXPECT_EQ(corner_terms(square(), one_smooth_corner).apex2corner_angle, (std::vector<int>{-1, -1, -1, 0}));
}

TEST(SharedCorners, FitAllNodesWithTheSameValencesOnTheBoundary) {
  const SharedCorners corners(square(), one_smooth_corner);
  PhaseNodes other = one_smooth_corner;
  other.nodes = {{{0.5, 0.5}, 3}};
  EXPECT_TRUE(corners.fit(other));
  EXPECT_FALSE(corners.fit(right_corners));
  other.boundary_nodes = {{0, 0.5, 3}};
  EXPECT_FALSE(corners.fit(other));
}

TEST(SharedCorners, SumsAreTheSameWhenAskedAgain) {
  const CadFace face = square();
  SharedCorners corners(face, one_smooth_corner);
  for (int pass = 0; pass < 2; ++pass) {
    for (int curve = 0; curve < 4; ++curve) {
      const Nurbs& nurbs = face.curves[curve];
      const double t = 0.3 * nurbs.begin() + 0.7 * nurbs.end();
      const Vec2 x = curve::point(nurbs, t);
      EXPECT_EQ(corners.sum_of_angles(curve, t, x), sum_of_corner_angles(corners.terms().corner_angles, x, -1, {}));
    }
  }
}

}  // namespace
}  // namespace quadrille::field
