#include "refine/even_vertices.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "../support/region_graphs.hpp"
#include "base/angle.hpp"
#include "layers/wall_spec.hpp"

namespace quadrille::refine {
namespace {

/// Of the vertices on a circle, from 0 to 1; ascending.
std::vector<double> turns_on(const QuadMesh& mesh, int curve, Vec2 centre) {
  std::vector<double> turns;
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& edge : *edges)
      if (edge.curve == curve)
        turns.push_back(wrap_two_pi(angle_of(mesh.nodes[side_start(mesh, edge.elem, edge.side)] - centre) + 1e-9) /
                        (2 * pi));
  std::ranges::sort(turns);
  return turns;
}

void expect_even(const std::vector<double>& turns, int count) {
  ASSERT_EQ(std::ssize(turns), count);
  for (int k = 0; k < count; ++k) EXPECT_NEAR(turns[k] * count, k, 1e-6);
}

TEST(EvenVertices, AroundAHoleThatIsNotInTheMiddle) {
  const Vec2 centre{0.3, 0.1};
  const SeparatrixGraph graph = hand_made::cut_annulus(5, 0.4, centre);
  RefineOptions options{.size = 0.15, .order = 3, .boundary_counts = {{"side_1", 23}}};
  const std::vector<double> free = turns_on(refined(graph, options), 1, centre);
  double uneven = 0;
  for (int k = 0; k < 23; ++k) uneven = std::max(uneven, std::abs(free[k] * 23 - k));
  EXPECT_GT(uneven, 0.05) << "by themselves they are not";
  options.boundary_counts[0].is_even = true;
  const QuadMesh mesh = refined(graph, options);
  EXPECT_TRUE(mesh.is_valid);
  expect_even(turns_on(mesh, 1, centre), 23);
}

TEST(EvenVertices, OnBothSidesOfAnInterface) {
  const QuadMesh mesh =
      refined(region_graphs::disc_in_square(), {.size = 0.4, .order = 3, .boundary_counts = {{"side_4", 26, true}}});
  EXPECT_TRUE(mesh.is_valid);
  for (const int curve : {4, 5}) expect_even(turns_on(mesh, curve, {}), 26);
}

TEST(EvenVertices, AWarningWhereLayersEndOnTheCurve) {
  const auto warns = [](const std::vector<layers::WallSpec>& walls) {
    Report report;
    const BlockLayout layout = block::extract_blocks(hand_made::unit_square(), report);
    RefineOptions options{.size = 0.2, .order = 2, .boundary_counts = {{"side_1", 9, true}}};
    options.walls = walls;
    refine(layout, options, report);
    return std::ranges::any_of(report.warnings(), [](const auto& warning) { return warning.code == "W-QUA-007"; });
  };
  EXPECT_FALSE(warns({}));
  EXPECT_TRUE(warns({layers::parse_wall_spec("side_0:first=0.02,layers=3", 0)}));
}

}  // namespace
}  // namespace quadrille::refine
