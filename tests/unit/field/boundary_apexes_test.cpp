#include "field/boundary_apexes.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"

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

}  // namespace
}  // namespace quadrille::field
