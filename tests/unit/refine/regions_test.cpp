// Meshes of several regions: interfaces are followed exactly, from both sides, by the same nodes.

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "../support/refined.hpp"
#include "../support/region_graphs.hpp"
#include "base/angle.hpp"
#include "curve/project.hpp"
#include "model/quad_mesh.hpp"
#include "refine/relax_sizes.hpp"
#include "refine/validity.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::refine {
namespace {

using region_graphs::disc_in_square, region_graphs::slit_plate, region_graphs::two_squares;

double distance_from_interfaces(const QuadMesh& mesh) {
  double greatest = 0;
  for (const QuadBoundaryEdge& e : mesh.interface_edges)
    for (const int node : side_nodes(mesh, e.elem, e.side))
      greatest = std::max(greatest, curve::project(mesh.face.curves[e.curve], mesh.nodes[node]).distance);
  return greatest / mesh.face.diameter;
}

/// By region: the area of its elements, which the corners of a fine mesh give well enough.
std::map<int, double> areas(const QuadMesh& mesh) {
  std::map<int, double> sum;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    double area = 0;
    for (int side = 0; side < 4; ++side) {
      const std::vector<int> nodes = side_nodes(mesh, e, side);
      for (std::size_t k = 1; k < nodes.size(); ++k)
        area += 0.5 * cross(mesh.nodes[nodes[k - 1]], mesh.nodes[nodes[k]]);
    }
    sum[mesh.block_region[mesh.elem_block[e]]] += area;
  }
  return sum;
}

/// Each edge on an interface is there once for each side, on the curves of a pair, with the same nodes.
void expect_named_from_both_sides(const QuadMesh& mesh) {
  std::map<std::vector<int>, int> curve_of;
  for (const QuadBoundaryEdge& e : mesh.interface_edges) curve_of[side_nodes(mesh, e.elem, e.side)] = e.curve;
  EXPECT_EQ(curve_of.size(), mesh.interface_edges.size());
  for (const auto& [nodes, curve] : curve_of) {
    const std::vector<int> from_other_side(nodes.rbegin(), nodes.rend());
    ASSERT_TRUE(curve_of.contains(from_other_side));
    EXPECT_EQ(curve_of[from_other_side], mesh.face.partners[curve]);
  }
}

TEST(Regions, TheCircleIsFollowedExactlyFromBothSides) {
  const QuadMesh mesh = refined(disc_in_square(), {.size = 0.4, .order = 5});
  EXPECT_TRUE(mesh.is_valid);
  EXPECT_GE(mesh.interface_edges.size(), 16u);
  EXPECT_LT(distance_from_interfaces(mesh), 1e-14);
  expect_named_from_both_sides(mesh);
  const std::map<int, double> area = areas(mesh);
  EXPECT_NEAR(area.at(1), pi, 0.01);
  EXPECT_NEAR(area.at(0), 16 - pi, 0.01);
}

TEST(Regions, InterfacesMeetTheTolerance) {
  const QuadMesh coarse = refined(disc_in_square(), {.size = 4, .order = 2, .geometry_tol = 1e-2});
  const QuadMesh exact = refined(disc_in_square(), {.size = 4, .order = 2, .geometry_tol = 1e-6});
  EXPECT_GT(exact.interface_edges.size(), 4 * coarse.interface_edges.size());
}

TEST(Regions, BothSidesOfASlitAreOneOrTwo) {
  const QuadMesh closed = refined(slit_plate(false), {.size = 0.5, .order = 2});
  const QuadMesh open = refined(slit_plate(true), {.size = 0.5, .order = 2});
  expect_named_from_both_sides(closed);
  EXPECT_EQ(closed.interface_edges.size(), 8u);
  EXPECT_TRUE(open.interface_edges.empty());
  EXPECT_EQ(open.boundary_edges.size(), closed.boundary_edges.size() + 8);
  // Four edges of order 2 have nine nodes; the tips are not doubled.
  EXPECT_EQ(open.nodes.size(), closed.nodes.size() + 7);
}

TEST(Regions, BothSidesOfACrackHaveNodesInTheSamePlaces) {
  RefineOptions options{.size = 0.5, .order = 3};
  options.size_field = sizing::SizeField(0.5, {{{{2, 0}, 0.06, 0.1}}, {}, 0}, {}, 1.3);  // below the crack
  const QuadMesh mesh = refined(slit_plate(true), options);
  std::vector<Vec2> above, below;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (const int node : side_nodes(mesh, e.elem, e.side))
      if (e.curve >= 4) (e.curve == 4 ? above : below).push_back(mesh.nodes[node]);
  ASSERT_EQ(above.size(), below.size());
  ASSERT_GT(above.size(), 20u);
  for (std::size_t k = 0; k < above.size(); ++k) EXPECT_LT(distance(above[k], below[below.size() - 1 - k]), 1e-13);
}

TEST(Regions, TheBoundarySlidesBesideAnInterface) {
  QuadMesh mesh = refined(disc_in_square(), {.size = 0.5, .order = 4, .relax = Relax::none});
  const QuadMesh before = mesh;
  const sizing::SizeField sizes(0.5);
  mesh = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3, .keeps_lengths = true}).mesh;
  double largest_move = 0;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (const int node : side_nodes(mesh, e.elem, e.side)) {
      EXPECT_LT(curve::project(mesh.face.curves[e.curve], mesh.nodes[node]).distance, 1e-12);
      largest_move = std::max(largest_move, distance(mesh.nodes[node], before.nodes[node]));
    }
  EXPECT_GT(largest_move, 1e-3);
}

TEST(Regions, VerticesOnInterfacesSlideToEqualLengths) {
  QuadMesh mesh = refined(two_squares(), {.size = 0.25, .order = 2, .relax = Relax::none});
  for (Vec2& x : mesh.nodes) x.y -= 0.1 * std::sin(pi * x.y);
  measure_elements(mesh);
  const sizing::SizeField sizes(0.25);
  mesh = relax_to_sizes(mesh, {.sizes = sizes, .tolerance = 1e-3}).mesh;
  expect_named_from_both_sides(mesh);
  EXPECT_LT(distance_from_interfaces(mesh), 1e-14);
  EXPECT_EQ(mesh.interface_edges.size(), 8u);
  for (const QuadBoundaryEdge& e : mesh.interface_edges)
    EXPECT_NEAR(std::remainder(mesh.nodes[side_start(mesh, e.elem, e.side)].y, 0.25), 0, 2e-3);
}

/// Heights of the first elements along an interface, by region.
std::map<int, double> first_heights(const QuadMesh& mesh) {
  std::map<int, double> height;
  for (const QuadBoundaryEdge& e : mesh.interface_edges) {
    const std::vector<int> beside = side_nodes(mesh, e.elem, (e.side + 1) % 4);
    height[mesh.block_region[mesh.elem_block[e.elem]]] =
        distance(mesh.nodes[beside.front()], mesh.nodes[beside.back()]);
  }
  return height;
}

TEST(Regions, SizesOnOneSideOfAnInterface) {
  SeparatrixGraph graph = two_squares();
  graph.face.curve_names[1] = graph.face.curve_names[7] = "wet";
  graph.face.region_names = {"fluid", "solid"};
  const auto heights = [&](const std::string& name) {
    RefineOptions options{.size = 0.25, .order = 2, .size_rule = sizing::SizeRule::nearest, .relax = Relax::none};
    sizing::SizeOptions sizes;
    sizes.size = 0.25;
    sizes.near = {{name, 0.05}};
    options.size_field = sizing::make_size_field(graph.face, sizes);
    return first_heights(refined(graph, options));
  };
  const std::map<int, double> fluid = heights("wet@fluid"), solid = heights("wet@solid"), both = heights("wet");
  EXPECT_LT(fluid.at(0), 0.07);
  EXPECT_NEAR(fluid.at(1), 0.25, 1e-9) << "the size does not act beyond the interface";
  EXPECT_NEAR(solid.at(0), fluid.at(1), 1e-9);
  EXPECT_NEAR(solid.at(1), fluid.at(0), 1e-9);
  EXPECT_NEAR(both.at(0), fluid.at(0), 1e-9);
  EXPECT_NEAR(both.at(1), fluid.at(0), 1e-9);
}

TEST(Regions, LayersOnOneSideOfAnInterface) {
  SeparatrixGraph graph = two_squares();
  graph.face.curve_names[1] = graph.face.curve_names[7] = "wet";
  graph.face.region_names = {"fluid", "solid"};
  RefineOptions options{.size = 0.25, .order = 3};
  options.walls = {layers::parse_wall_spec("wet@fluid:first=0.01,layers=4,growth=1.2")};
  const std::map<int, double> fluid = first_heights(refined(graph, options));
  EXPECT_NEAR(fluid.at(0), 0.01, 1e-12);
  EXPECT_NEAR(fluid.at(1), 0.25, 0.02) << "layers do not go on beyond the interface";
  options.walls = {layers::parse_wall_spec("wet@1:first=0.01,layers=4,growth=1.2")};
  const std::map<int, double> solid = first_heights(refined(graph, options));
  EXPECT_NEAR(solid.at(1), 0.01, 1e-12);
  EXPECT_NEAR(solid.at(0), 0.25, 0.02);
  options.walls = {layers::parse_wall_spec("wet:first=0.01,layers=4,growth=1.2")};
  const std::map<int, double> both = first_heights(refined(graph, options));
  EXPECT_NEAR(both.at(0), 0.01, 1e-12);
  EXPECT_NEAR(both.at(1), 0.01, 1e-12);
}

TEST(Regions, LayersAlongACircleHaveOneHeight) {
  SeparatrixGraph graph = disc_in_square();
  RefineOptions options{.size = 0.4, .order = 4};
  options.walls = {layers::parse_wall_spec("side_4@region_0:first=0.02,layers=3,growth=1.3")};
  const QuadMesh mesh = refined(graph, options);
  EXPECT_TRUE(mesh.is_valid);
  for (const QuadBoundaryEdge& e : mesh.interface_edges) {
    if (e.curve != 4) continue;
    for (const int node : side_nodes(mesh, e.elem, (e.side + 2) % 4)) EXPECT_NEAR(norm(mesh.nodes[node]), 1.02, 1e-9);
  }
}

}  // namespace
}  // namespace quadrille::refine
