#include "placement/placement_objective.hpp"

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

TEST(MeanScale, is_that_of_the_line_as_far_as_it_is_inside) {
  const CadFace face = square();
  const curve::FaceBoundary boundary(face);
  const LogScale log_scale = [](Vec2 x, Vec2& gradient) {
    gradient = {1, 0};
    return x.x;
  };
  const Vec2 x{0.5, 0.5};
  EXPECT_NEAR(mean_scale(log_scale, boundary, x, {0.8, 0.5}), (std::exp(0.8) - std::exp(0.5)) / 0.3, 1e-8);
  EXPECT_NEAR(mean_scale(log_scale, boundary, x, {3, 0.5}), (std::exp(1) - std::exp(0.5)) / 0.5, 1e-7);
  EXPECT_NEAR(mean_scale(log_scale, boundary, x, x), std::exp(0.5), 1e-14);
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

using namespace testing_faces;

/// A node of each valence, in order.
CriticalPoints nodes_at(const std::vector<Vec2>& places, const std::vector<int>& valences) {
  CriticalPoints points;
  for (std::size_t k = 0; k < places.size(); ++k) {
    points.critical_points.emplace_back();
    points.critical_points.back().position = places[k];
    points.critical_points.back().valence = valences[k];
  }
  return points;
}

/// The sum of 3 |x|^2 over all nodes.
NodeEnergy energy_of_squares(const CriticalPoints& points) {
  NodeEnergy sum;
  for (const CriticalPoint& node : points.critical_points) {
    sum.value += 3 * norm2(node.position);
    sum.gradient.push_back(6 * node.position);
  }
  return sum;
}

struct InADisc : testing::Test {
  CadFace face = make_face({circle({0, 0}, 2)});
  SmoothBoundaryDistance boundary{face};
  EnergyFunction energy = energy_of_squares;
};

TEST_F(InADisc, the_boundary_term_is_the_logarithm_of_the_smooth_distance_times_the_squared_index) {
  const PlacementObjective objective{energy, boundary, 0.1, {0, 2}, {}};
  const CriticalPoints points = nodes_at({{1, 0}, {0, 1.5}, {0, -0.5}}, {3, 5, 6});
  // delta = (R^2 - r^2) / (2 R), with d^2 = 1 for valence 3 and 4 for valence 6; node 1 is not free.
  const double expected = 3 * (1 + 2.25 + 0.25) - 0.1 * pi * (std::log(3.0 / 4) + 4 * std::log((4 - 0.25) / 4));
  const NodeEnergy sum = objective.at(points);
  EXPECT_NEAR(sum.value, expected, 1e-11);
  EXPECT_NEAR(distance(sum.gradient[0], {6 + 0.1 * pi * 2 / 3, 0}), 0, 1e-11);
  EXPECT_EQ(sum.gradient[1], (Vec2{0, 9}));
  EXPECT_NEAR(distance(sum.gradient[2], {0, -3 - 0.1 * pi * 4 / 3.75}), 0, 1e-11);
}

TEST_F(InADisc, repulsion_terms_are_added_with_their_gradient) {
  const RepulsionTerm term{0, 1, {}, 0.5, 2};
  const PlacementObjective with{energy, boundary, 0.1, {0, 1}, {term}}, without{energy, boundary, 0.1, {0, 1}, {}};
  const CriticalPoints points = nodes_at({{0, 0}, {0.25, 0}}, {3, 5});
  const NodeEnergy a = with.at(points), b = without.at(points);
  EXPECT_NEAR(a.value - b.value, 2, 1e-12);  // (reach / r - 1)^3 = 1
  std::vector<Vec2> repulsion(2);
  repulsion_energy(term, points, repulsion);
  for (int k = 0; k < 2; ++k) EXPECT_NEAR(distance(a.gradient[k] - b.gradient[k], repulsion[k]), 0, 1e-12);
  EXPECT_GT(norm(repulsion[0]), 1);
}

TEST_F(InADisc, no_node_covers_more_than_half_of_its_distance_to_the_boundary) {
  const PlacementObjective objective{energy, boundary, 0.1, {0, 1}, {}};
  const CriticalPoints points = nodes_at({{1, 0}, {-1, 0}}, {3, 3});
  EXPECT_EQ(objective.allowed_part(points, {{0.4, 0}, {0.4, 0}}), 1);
  EXPECT_NEAR(objective.allowed_part(points, {{2, 0}, {2, 0}}), 0.25, 1e-6);
  EXPECT_NEAR(objective.allowed_part(points, {{2, 0}, {2, 4}}), 0.5 / std::sqrt(20.0), 1e-6);
}

TEST_F(InADisc, no_node_covers_more_than_half_of_its_distance_to_another) {
  const CriticalPoints points = nodes_at({{0.1, 0}, {-0.1, 0}}, {3, 3});
  const PlacementObjective both{energy, boundary, 0.1, {0, 1}, {}}, one{energy, boundary, 0.1, {0}, {}};
  EXPECT_NEAR(both.allowed_part(points, {{-0.2, 0}, {0.2, 0}}), 0.25, 1e-12);
  EXPECT_EQ(both.allowed_part(points, {{0.2, 0}, {0.2, 0}}), 1);  // the distance stays
  EXPECT_NEAR(one.allowed_part(points, {{-0.2, 0}, {}}), 0.5, 1e-12);
}

TEST_F(InADisc, no_node_covers_more_than_half_of_its_distance_to_a_corner_that_attracts_it) {
  const CriticalPoints points = nodes_at({{0, 0}}, {3});
  const RepulsionTerm corner{0, {}, {0.4, 0}, 0.1, 1};
  const PlacementObjective objective{energy, boundary, 0.1, {0}, {corner}};
  EXPECT_NEAR(objective.allowed_part(points, {{0.8, 0}}), 0.25, 1e-12);
}

}  // namespace
}  // namespace quadrille::placement
