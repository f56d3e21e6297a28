#include "triangulate/edge_fit.hpp"

#include <gtest/gtest.h>

#include "faces.hpp"

namespace quadrille::triangulate {
namespace {

using namespace testing_faces;

TEST(EdgeFit, TurnIsTheSumOfAbsoluteTurns) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const EdgeFit fit(outline, 4);
  EXPECT_NEAR(fit.turn(1, face.curves[1].begin(), face.curves[1].end()), pi, 1e-12);
  EXPECT_EQ(fit.turn(0, 0, 2), 0);
}

TEST(EdgeFit, NodesLieOnTheCircleAtLobattoFractionsOfTheLength) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const auto nodes = EdgeFit(outline, 4).inner_nodes(1, face.curves[1].begin(), face.curves[1].end());
  ASSERT_EQ(nodes.size(), 3u);
  for (const Vec2 x : nodes) EXPECT_NEAR(norm(x), 1, 1e-15);
  EXPECT_NEAR(angle_of(nodes[0]), half_pi * (1 - std::sqrt(3.0 / 7)), 1e-14);
  EXPECT_NEAR(angle_of(nodes[1]), half_pi, 1e-14);
}

TEST(EdgeFit, ErrorOfOrderEightOnACircle) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  const curve::ArcLength& length = outline.arc_length(1);
  const EdgeFit fit(outline, 8);
  const double error45 = fit.error(1, 0, length.parameter(pi / 4)), error90 = fit.error(1, 0, length.parameter(pi / 2));
  EXPECT_LT(error45, 1e-12);  // known: 8e-13 of the radius
  EXPECT_GT(error45, 1e-13);
  EXPECT_GT(error90, 200 * error45);
}

TEST(EdgeFit, AStraightEdgeHasNoError) {
  const CadFace face = half_disc();
  const Outline outline(face, 1e-13);
  EXPECT_LT(EdgeFit(outline, 8).error(0, 0.1, 1.7), 1e-15);
}

}  // namespace
}  // namespace quadrille::triangulate
