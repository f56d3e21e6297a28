#include "placement/repulsion_terms.hpp"

#include <gtest/gtest.h>

#include "../triangulate/faces.hpp"

namespace quadrille::placement {
namespace {

using namespace testing_faces;

CriticalPoints two_nodes(Vec2 a, int valence_a, Vec2 b, int valence_b) {
  CriticalPoints points;
  points.critical_points.resize(2);
  points.critical_points[0].position = a;
  points.critical_points[0].valence = valence_a;
  points.critical_points[1].position = b;
  points.critical_points[1].valence = valence_b;
  return points;
}

TEST(RepulsionTerms, stand_between_opposites_only) {
  const CadFace face = square();
  EXPECT_TRUE(repulsion_terms(face, two_nodes({0.2, 0.5}, 3, {0.8, 0.5}, 3), {true, true}, 0.1).empty());
  EXPECT_TRUE(repulsion_terms(face, two_nodes({0.2, 0.5}, 3, {0.8, 0.5}, 5), {false, false}, 0.1).empty());
  const std::vector<RepulsionTerm> terms =
      repulsion_terms(face, two_nodes({0.2, 0.5}, 3, {0.8, 0.5}, 6), {true, false}, 0.1);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_EQ(terms[0].reach, 0.1);
  EXPECT_NEAR(terms[0].strength, 4 * pi, 1e-14);
}

TEST(RepulsionTerms, reach_half_as_far_as_the_nodes_were_apart) {
  const CriticalPoints points = two_nodes({0.2, 0.5}, 3, {0.25, 0.5}, 5);
  const std::vector<RepulsionTerm> terms = repulsion_terms(square(), points, {true, true}, 0.1);
  ASSERT_EQ(terms.size(), 1u);
  EXPECT_NEAR(terms[0].reach, 0.025, 1e-15);
  std::vector<Vec2> gradient(2);
  EXPECT_EQ(repulsion_energy(terms[0], points, gradient), 0);
}

TEST(RepulsionTerms, stand_before_corners_of_the_other_charge) {
  CriticalPoints points = two_nodes({0.2, 0.5}, 3, {0.2, 0.6}, 3);
  Corner corner;
  corner.position = {0, 0};
  for (const int valence : {1, 2}) {  // beta = 0 and -4
    corner.valence = valence;
    points.corners = {corner};
    EXPECT_EQ(repulsion_terms(square(), points, {true, false}, 0.1).size(), valence - 1u);
  }
  points.corners = {};
  points.boundary_nodes.push_back({0, 0.5, {0.5, 0}, 3, NodeSource::feature});  // beta = -2
  EXPECT_EQ(repulsion_terms(square(), points, {true, true}, 0.1).size(), 2u);
  points.boundary_nodes[0].valence = 1;  // beta = 2
  EXPECT_EQ(repulsion_terms(square(), points, {true, true}, 0.1).size(), 0u);
}

TEST(RepulsionTerms, balance_the_attraction_at_0_68_of_their_reach) {
  const RepulsionTerm term{0, 1, {}, 0.1, 2 * pi};
  const auto push = [&](double r) {
    std::vector<Vec2> gradient(2);
    repulsion_energy(term, two_nodes({0, 0}, 3, {r, 0}, 5), gradient);
    return gradient[0].x - 2 * pi / r;  // its own and that of 2 pi ln r
  };
  EXPECT_GT(push(0.067), 0);
  EXPECT_LT(push(0.069), 0);
}

TEST(RepulsionTerms, their_gradient_is_that_of_their_value) {
  const double h = 1e-7;
  for (const RepulsionTerm& term : {RepulsionTerm{0, 1, {}, 0.1, 2}, RepulsionTerm{0, {}, {0.05, 0.03}, 0.1, 2}}) {
    const auto at = [&](double dx, double dy, std::vector<Vec2>& gradient) {
      return repulsion_energy(term, two_nodes({dx, dy}, 3, {0.05, 0.03}, 5), gradient);
    };
    std::vector<Vec2> gradient(2), unused(2);
    at(0, 0, gradient);
    const Vec2 slope{(at(h, 0, unused) - at(-h, 0, unused)) / (2 * h),
                     (at(0, h, unused) - at(0, -h, unused)) / (2 * h)};
    EXPECT_NEAR(distance(gradient[0], slope), 0, 1e-6 * norm(slope));
    EXPECT_GT(norm(slope), 1);
    EXPECT_EQ(gradient[1], term.other == 1 ? -gradient[0] : Vec2{});
  }
}

}  // namespace
}  // namespace quadrille::placement
