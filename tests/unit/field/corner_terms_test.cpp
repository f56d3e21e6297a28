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
  const CadFace face = square();
  const SharedCorners corners(face, one_smooth_corner);
  PhaseNodes other = one_smooth_corner;
  other.nodes = {{{0.5, 0.5}, 3}};
  EXPECT_TRUE(corners.fit(other));
  EXPECT_FALSE(corners.fit(right_corners));
  other.boundary_nodes = {{0, 0.5, 3}};
  EXPECT_FALSE(corners.fit(other));
}

TEST(SharedCorners, SamplesAreThoseOfTheParametersAskedFor) {
  const CadFace face = square();
  SharedCorners corners(face, one_smooth_corner);
  const Nurbs& nurbs = face.curves[1];
  const auto at = [&](double f) { return (1 - f) * nurbs.begin() + f * nurbs.end(); };
  // The second and third lists start as the first does, the last is the first once more.
  const std::vector<std::vector<double>> lists{{at(0.3), at(0.7)}, {at(0.3), at(0.8)}, {at(0.3)}, {at(0.3), at(0.7)}};
  for (const std::vector<double>& t : lists) {
    const BoundarySamples& samples = corners.samples(1, t);
    ASSERT_EQ(samples.t, t);
    for (std::size_t i = 0; i < t.size(); ++i) {
      const Vec2 x = curve::point(nurbs, t[i]);
      EXPECT_EQ(samples.x[i], x);
      EXPECT_EQ(samples.apexes[i], -1);
      EXPECT_EQ(samples.tangent_angles[i], angle_of(curve::tangent(nurbs, t[i])));
      EXPECT_EQ(samples.corner_angles[i], sum_of_corner_angles(corners.terms().corner_angles, x, -1, {}));
    }
  }
  EXPECT_EQ(corners.samples(1, std::vector{nurbs.begin(), at(0.5), nurbs.end()}).apexes, (std::vector<int>{1, -1, 2}));
}

TEST(SharedCorners, KnowTheImagesOfEachNode) {
  const CadFace face = square();
  SharedCorners corners(face, right_corners);
  const auto positions = [&](Vec2 x) {
    std::vector<Vec2> found;
    for (const MirrorImage& image : corners.images(x)) found.push_back(image.position);
    return found;
  };
  for (const Vec2 x : {Vec2{0.1, 0.2}, Vec2{0.1, 0.4}, Vec2{0.1, 0.2}}) {
    std::vector<Vec2> expected;
    for (const MirrorImage& image : MirrorImages(face).of(x)) expected.push_back(image.position);
    EXPECT_FALSE(expected.empty());
    EXPECT_EQ(positions(x), expected);
  }
}

}  // namespace
}  // namespace quadrille::field
