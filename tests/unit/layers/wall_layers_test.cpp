#include "layers/wall_layers.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>
#include <string>

#include "../hand_made.hpp"
#include "base/error.hpp"
#include "block/extract_blocks.hpp"
#include "curve/project.hpp"
#include "refine/refine.hpp"

namespace quadrille::layers {
namespace {

QuadMesh layered(const SeparatrixGraph& graph, double size, const std::vector<std::string>& walls, Report& report,
                 int order = 4) {
  refine::RefineOptions options;
  options.size = size, options.order = order;
  for (const std::string& wall : walls) options.walls.push_back(parse_wall_spec(wall));
  return refine::refine(block::extract_blocks(graph, report), options, report);
}

QuadMesh layered(const SeparatrixGraph& graph, double size, const std::vector<std::string>& walls, int order = 4) {
  Report report;
  return layered(graph, size, walls, report, order);
}

int vertex(const QuadMesh& mesh, int elem, int k) {
  const int n = mesh.order, width = n + 1;
  const std::array<int, 4> corners{0, n, width * width - 1, width * n};
  return mesh.elem_nodes[elem * width * width + corners[(k + 4) % 4]];
}

/// Distances from a curve of the vertices above each of its vertices, element by element outwards, at most `most`.
std::vector<std::vector<double>> heights_above(const QuadMesh& mesh, int curve, std::size_t most) {
  std::map<std::set<int>, std::vector<std::array<int, 2>>> edges;
  for (int e = 0; e < mesh.num_elems(); ++e)
    for (int k = 0; k < 4; ++k) edges[{vertex(mesh, e, k), vertex(mesh, e, k + 1)}].push_back({e, k});
  std::vector<std::vector<double>> columns;
  for (const QuadBoundaryEdge& b : mesh.boundary_edges) {
    if (b.curve != curve) continue;
    for (const int end : {0, 1}) {
      std::vector<double> heights;
      for (std::array<int, 2> at{b.elem, b.side}; heights.size() < most;) {
        // The sides are walked counter-clockwise, so the wall's end is on the left in all elements of the column.
        const int above = vertex(mesh, at[0], at[1] + (end == 0 ? 3 : 2));
        heights.push_back(curve::project(mesh.face.curves[curve], mesh.nodes[above]).distance);
        const auto& both = edges[{vertex(mesh, at[0], at[1] + 2), vertex(mesh, at[0], at[1] + 3)}];
        if (both.size() < 2) break;
        at = both[0][0] == at[0] ? both[1] : both[0];
      }
      columns.push_back(heights);
    }
  }
  return columns;
}

double least(const std::vector<double>& values) { return *std::min_element(values.begin(), values.end()); }

/// A duct from x = 0 to 4 above the flat wall y = 0, 1 high at its ends and 2 in the middle: side_2 is the roof.
SeparatrixGraph vault() {
  return hand_made::one_block(
      hand_made::face({{curve::segment({0, 0}, {4, 0}), curve::segment({4, 0}, {4, 1}),
                        curve::cubic_spline({0, 1, 2}, {{4, 1}, {2, 2}, {0, 1}}, {-2, 0}, {-2, 0}),
                        curve::segment({0, 1}, {0, 0})}},
                      5),
      {{0}, {1}, {2}, {3}});
}

TEST(WallLayers, AreAtConstantDistanceHoweverWideTheBlock) {
  const QuadMesh mesh = layered(vault(), 0.3, {"side_0:first=0.01,growth=1.2,layers=8"});
  EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
  const std::vector<std::vector<double>> columns = heights_above(mesh, 0, 8);
  EXPECT_GT(columns.size(), 20u);
  for (const std::vector<double>& heights : columns)
    for (std::size_t k = 0; k < 8; ++k) EXPECT_NEAR(heights[k], 0.01 * (std::pow(1.2, k + 1) - 1) / 0.2, 1e-10);
}

TEST(WallLayers, AllNodesInsideALayerLieAtItsHeights) {
  const QuadMesh mesh = layered(vault(), 0.3, {"side_0:first=0.02,layers=3,law=uniform"}, 5);
  std::set<long> heights;
  for (const Vec2 x : mesh.nodes)
    if (x.y < 0.0601) heights.insert(std::lround(x.y * 1e9));
  EXPECT_EQ(heights.size(), 16u);  // GLL points of three layers of order 5
}

TEST(WallLayers, GoOnGrowingIntoTheInteriorUpToTheWantedSize) {
  const QuadMesh mesh = layered(hand_made::unit_square(), 0.1, {"side_0:first=1e-3,growth=1.25,layers=5"});
  for (const std::vector<double>& heights : heights_above(mesh, 0, 1000)) {
    EXPECT_NEAR(heights.back(), 1, 1e-12);
    double below = heights[0];
    for (std::size_t k = 1; k < heights.size(); ++k) {
      const double layer = heights[k] - heights[k - 1];
      EXPECT_LE(layer, 1.25 * (1 + 1e-5) * below);
      EXPECT_LE(layer, 0.1 * (1 + 1e-5));
      below = layer;
    }
    EXPECT_GT(below, 0.07);
  }
}

TEST(WallLayers, BothWallsOfAChannelGetTheirs) {
  Report report;
  const QuadMesh mesh = layered(vault(), 0.3, {"side_0:first=1e-3,layers=6", "side_2:first=2e-3,layers=4"}, report);
  for (const std::vector<double>& heights : heights_above(mesh, 0, 1)) EXPECT_NEAR(heights[0], 1e-3, 1e-12);
  for (const std::vector<double>& heights : heights_above(mesh, 2, 1)) EXPECT_NEAR(heights[0], 2e-3, 1e-12);
  ASSERT_EQ(report.warnings().size(), 1u);
  EXPECT_EQ(report.warnings()[0].code, "W-WAL-001");
}

TEST(WallLayers, RunThroughConvexAndReflexCorners) {
  std::string all = "side_0";
  for (int k = 1; k < 6; ++k) all += ",side_" + std::to_string(k);
  const QuadMesh mesh = layered(hand_made::l_shape(), 0.2, {all + ":first=2e-3,layers=6"});
  EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
  EXPECT_GT(least(mesh.elem_scaled_jacobian), 0.85);
  for (int curve = 0; curve < 6; ++curve) {
    int far = 0;
    for (const std::vector<double>& heights : heights_above(mesh, curve, 1)) far += std::abs(heights[0] - 2e-3) < 1e-12;
    EXPECT_GT(far, 20) << curve;
  }
}

TEST(WallLayers, GoAroundClosedWalls) {
  for (const int cuts : {1, 3}) {
    const QuadMesh mesh = layered(hand_made::cut_annulus(cuts), 0.2, {"side_1:first=1e-3,layers=8"});
    EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
    for (const std::vector<double>& heights : heights_above(mesh, 1, 8))
      EXPECT_NEAR(heights[7], 1e-3 * (std::pow(1.2, 8) - 1) / 0.2, 1e-11);
  }
}

TEST(WallLayers, ThatDoNotFitAreRefusedWithTheLargestNumberThatDoes) {
  std::string message;
  try {
    layered(hand_made::cut_annulus(4), 0.2, {"side_1:first=0.01,layers=40"});
    FAIL() << "40 layers were taken";
  } catch (const ComputeError& error) {
    message = error.what();
  }
  const std::size_t at = message.find("at most ");
  ASSERT_NE(at, std::string::npos) << message;
  const int most = std::stoi(message.substr(at + 8));
  EXPECT_GE(most, 8);
  const auto wall = [](int layers) { return "side_1:first=0.01,layers=" + std::to_string(layers); };
  EXPECT_GT(layered(hand_made::cut_annulus(4), 0.2, {wall(most)}).num_elems(), 0);
  EXPECT_THROW(layered(hand_made::cut_annulus(4), 0.2, {wall(most + 1)}), ComputeError);
  const QuadMesh fitting = layered(hand_made::cut_annulus(4), 0.2, {"side_1:first=0.01,layers=fit"});
  EXPECT_EQ(fitting.num_elems(), layered(hand_made::cut_annulus(4), 0.2, {wall(most)}).num_elems());
}

TEST(WallLayers, OfASymmetricFaceAreSymmetric) {
  const QuadMesh mesh = layered(vault(), 0.3, {"side_0:first=5e-3,layers=7", "side_2:first=0.01,layers=4"});
  for (const Vec2 x : mesh.nodes) {
    double nearest = 1e300;
    for (const Vec2 y : mesh.nodes) nearest = std::min(nearest, distance({4 - x.x, x.y}, y));
    EXPECT_LE(nearest, 1e-9);
  }
}

TEST(WallLayers, StretchesOfOneWallTakeTheFinestLayersThatAnyAsksFor) {
  // The elbow's outer side is a line and an arc in one side of its block.
  Report report;
  const QuadMesh mesh = layered(hand_made::elbow(), 0.3, {"0:first=0.02,layers=4", "1:first=0.01,layers=5"}, report);
  for (const std::vector<double>& heights : heights_above(mesh, 0, 1)) EXPECT_NEAR(heights[0], 0.01, 5e-4);
  ASSERT_FALSE(report.warnings().empty());
  EXPECT_EQ(report.warnings()[0].code, "W-WAL-002");
}

TEST(WallLayers, NoEdgeBelongsToTwoNames) {
  // Layers at the elbow's ends grade the chord along it, whose long sides are a line and an arc each.
  SeparatrixGraph graph = hand_made::elbow();
  graph.face.curve_names = {"straight", "bend", "out", "bend", "straight", "in"};
  graph.face.unnamed_curves.clear();
  refine::RefineOptions options;
  options.size = 0.4, options.geometry_tol = 0.05;
  options.walls = {parse_wall_spec("in:first=0.01,layers=4"), parse_wall_spec("out:first=0.01,layers=4")};
  Report report;
  const QuadMesh mesh = refine::refine(block::extract_blocks(graph, report), options, report);
  EXPECT_GT(least(mesh.elem_jacobian_bound), 0);
  for (const QuadBoundaryEdge& edge : mesh.boundary_edges)
    for (const int end : {0, 1}) {
      const Vec2 x = mesh.nodes[vertex(mesh, edge.elem, edge.side + end)];
      EXPECT_LE(curve::project(mesh.face.curves[edge.curve], x).distance, 1e-12);
    }
}

TEST(WallLayers, AreProvedValidAtManyOrders) {
  for (const int order : {1, 2, 3, 6, 8})
    EXPECT_GT(
        least(layered(hand_made::quarter_annulus(), 0.4, {"side_3:first=1e-4,layers=10"}, order).elem_jacobian_bound),
        0)
        << order;
}

}  // namespace
}  // namespace quadrille::layers
