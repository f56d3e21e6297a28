#include "field/explicit_terms.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::field {
namespace {

using namespace testing_faces;

PhaseNodes four_corners() { return {{}, {{0, 1}, {1, 1}, {2, 1}, {3, 1}}, {}}; }

TEST(BoundaryApexes, AreTheJointsWithTheirValences) {
  const CadFace face = square();
  const BoundaryApexes found = boundary_apexes(face, {{}, {{2, 1}}, {}});
  ASSERT_EQ(found.apexes.size(), 4u);
  EXPECT_EQ(found.offsets, (std::vector<int>{0, 1, 2, 3, 4}));
  for (int c = 0; c < 4; ++c) {
    EXPECT_EQ(found.apexes[c].curve, c);
    EXPECT_EQ(found.apexes[c].t, face.curves[c].begin());
    EXPECT_NEAR(found.apexes[c].interior_angle, half_pi, 1e-15);
    EXPECT_EQ(found.apexes[c].valence, c == 2 ? 1 : 2);
  }
}

TEST(BoundaryApexes, HoldBoundaryNodesByCurveAndParameter) {
  const CadFace face = square();
  const Nurbs& curve = face.curves[1];
  const auto at = [&](double f) { return curve.begin() * (1 - f) + curve.end() * f; };
  const BoundaryApexes found = boundary_apexes(face, {{}, {}, {{1, at(0.75), 3}, {1, at(0.25), 1}}});
  ASSERT_EQ(found.apexes.size(), 6u);
  EXPECT_EQ(found.offsets, (std::vector<int>{0, 1, 4, 5, 6}));
  EXPECT_EQ(found.apexes[2].t, at(0.25));
  EXPECT_EQ(found.apexes[2].valence, 1);
  EXPECT_EQ(found.apexes[3].valence, 3);
  EXPECT_NEAR(found.apexes[3].interior_angle, pi, 1e-15);
  EXPECT_EQ(find_apex(face, found, 1, at(0.75)), 3);
  EXPECT_EQ(find_apex(face, found, 1, at(0.5)), -1);
}

TEST(BoundaryApexes, AtTheEndOfACurveAreTheJointOfTheNext) {
  const CadFace face = square();
  const BoundaryApexes found = boundary_apexes(face, {{}, {}, {{3, face.curves[3].end(), 1}}});
  ASSERT_EQ(found.apexes.size(), 4u);
  EXPECT_EQ(found.apexes[0].valence, 1);
  EXPECT_EQ(find_apex(face, found, 3, face.curves[3].end()), 0);
  EXPECT_EQ(find_apex(face, found, 0, face.curves[0].begin()), 0);
}

TEST(BoundaryApexes, HaveTheTangentsOfBothSides) {
  const CadFace face = make_face({polygon({{0, 0}, {4, 0}, {4, 3}})});
  const BoundaryApexes found = boundary_apexes(face, {});
  const ApexTangents at_first = tangents_at(face, found.apexes[0]), at_second = tangents_at(face, found.apexes[1]);
  EXPECT_NEAR(distance(at_first.in, {-0.8, -0.6}), 0, 1e-15);
  EXPECT_NEAR(distance(at_first.out, {1, 0}), 0, 1e-15);
  EXPECT_NEAR(distance(at_second.in, {1, 0}), 0, 1e-15);
  EXPECT_NEAR(distance(at_second.out, {0, 1}), 0, 1e-15);
}

TEST(BoundaryApexes, RefuseWhatDoesNotExistOrCoincides) {
  const CadFace face = square();
  const double middle = (face.curves[0].begin() + face.curves[0].end()) / 2;
  EXPECT_THROW(boundary_apexes(face, {{}, {{4, 1}}, {}}), ComputeError);
  EXPECT_THROW(boundary_apexes(face, {{}, {{1, 1}, {1, 1}}, {}}), ComputeError);
  EXPECT_THROW(boundary_apexes(face, {{}, {}, {{7, middle, 3}}}), ComputeError);
  EXPECT_THROW(boundary_apexes(face, {{}, {}, {{0, face.curves[0].end() + 1, 3}}}), ComputeError);
  EXPECT_THROW(boundary_apexes(face, {{}, {}, {{0, middle, 3}, {0, middle, 3}}}), ComputeError);
  EXPECT_NO_THROW(boundary_apexes(face, {{}, {{1, 1}}, {{0, middle, 3}}}));
}

TEST(IndexSum, CountsNodesCornersAndBoundaryNodes) {
  const CadFace face = square();
  EXPECT_NO_THROW(require_valence_sum(face, four_corners()));
  PhaseNodes prescribed = four_corners();
  prescribed.nodes.push_back({{0.5, 0.5}, 3});
  EXPECT_THROW(require_valence_sum(face, prescribed), ComputeError);
  prescribed.boundary_nodes.push_back({0, 0.5, 3});
  EXPECT_NO_THROW(require_valence_sum(face, prescribed));
}

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
