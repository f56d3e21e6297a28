#include "field/explicit_terms.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

ExplicitTerms terms_of(const CadFace& face, const PhaseNodes& prescribed) {
  SharedCorners corners(face, prescribed);
  return explicit_terms(corners, prescribed.nodes);
}

TEST(ExplicitTerms, OfASquareWithRightCornersAreNone) {
  const ExplicitTerms found = terms_of(square(), {{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}});
  EXPECT_TRUE(found.terms.corner_angles.empty());
  EXPECT_TRUE(found.centres.empty());
}

TEST(ExplicitTerms, HaveACornerAngleWhereTheDataJump) {
  const CadFace face = square();
  const ExplicitTerms found = terms_of(face, {{}, {{0, 1}, {1, 1}, {2, 1}, {3, 2}}, {}});
  ASSERT_EQ(found.terms.corner_angles.size(), 1u);
  const CornerAngle& corner = found.terms.corner_angles[0];
  EXPECT_NEAR(corner.beta, 4 - 2 * pi * 2 / half_pi, 1e-14);
  const Vec2 joint = face.curves[3].poles.front(),
             centre = (face.curves[0].poles.front() + face.curves[2].poles.front()) / 2;
  EXPECT_EQ(corner.apex, joint);
  // The pole lies outside, on the corner's exterior bisector.
  EXPECT_NEAR(cross(corner.pole - joint, joint - centre), 0, 1e-14);
  EXPECT_GT(dot(corner.pole - joint, joint - centre), 0);
}

// Every image beyond the outline adds a centre; the turns inside the hole are D = 4 + sum (2 - V) in total.
TEST(ExplicitTerms, OfAnAnnulusKeepTheTurnsOfTheHole) {
  const ExplicitTerms found = terms_of(annulus(), {{{{0.75, 0}, 3}, {{0, 0.7}, 5}}, {}, {}});
  ASSERT_EQ(found.terms.nodes.size(), 2u);
  ASSERT_EQ(found.terms.holes.size(), 1u);
  EXPECT_EQ(found.terms.nodes[0].turns, 1);
  EXPECT_EQ(found.terms.nodes[1].turns, -1);
  ASSERT_EQ(found.centres.size(), 3 + found.terms.images.size());
  int turns_of_hole = 0, num_beyond = 0;
  for (const TurnCentre& centre : found.centres) {
    if (centre.loop == 1) turns_of_hole += centre.turns;
    if (centre.loop == 0) ++num_beyond;
    const double radius = norm(centre.position);
    const int side = radius < 0.5 ? 1 : radius < 1 ? -1 : 0;
    EXPECT_EQ(centre.loop, side) << radius;
  }
  EXPECT_EQ(turns_of_hole, 4);
  EXPECT_GT(num_beyond, 0);
}

TEST(ExplicitTerms, KnowHowOftenLoopsWindRoundTheirCentres) {
  const TurnCentre node{{}, 1, -1}, beyond{{}, 1, 0}, in_second_hole{{}, 1, 2};
  const auto numbers = [](const TurnCentre& c) {
    return std::vector<int>{c.winding_number(0), c.winding_number(1), c.winding_number(2)};
  };
  EXPECT_EQ(numbers(node), (std::vector<int>{1, 0, 0}));
  EXPECT_EQ(numbers(beyond), (std::vector<int>{0, 0, 0}));
  EXPECT_EQ(numbers(in_second_hole), (std::vector<int>{1, 0, -1}));
}

TEST(LoopCentres, SumTheFarOnesAsIfEachWereFollowed) {
  const CadFace face = annulus();
  const int hole = 1;
  const Nurbs& curve = face.curves[face.loop_offsets[hole]];
  const std::vector<TurnCentre> centres{
      {{0.6, 0.1}, 1, -1}, {{2.5, -1}, -2, 0}, {{-3, 1.7}, 5, 0}, {{0, 0.1}, 3, hole}};
  const LoopCentres seen(face, hole, centres);
  ASSERT_EQ(seen.followed().size(), 2u);  // the near one and that inside the hole
  double sum_at_start = 0, followed[2] = {};
  for (int k = 0; k <= 100; ++k) {
    const Vec2 x = curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * k / 100);
    double sum = 0;
    for (int i = 1; i <= 2; ++i) {
      const double angle = angle_of(x - centres[i].position);
      followed[i - 1] = k == 0 ? angle : followed[i - 1] + wrap_pi(angle - followed[i - 1]);
      sum += centres[i].turns * followed[i - 1];
    }
    EXPECT_NEAR(seen.sum_of_far(x), sum, 1e-13);
    if (k == 0) sum_at_start = sum;
    if (k == 100) {
      EXPECT_NEAR(sum, sum_at_start, 1e-13);
    }
  }
}

}  // namespace
}  // namespace quadrille::field
