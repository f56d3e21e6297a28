#include "refine/relax.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "curve/project.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

/// The unit square, inner nodes moved by `move`.
QuadMesh moved_square(int order, const std::function<Vec2(Vec2)>& move) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, order, 5e-7});
  for (Vec2& x : mesh.nodes) x += move(x);
  measure_elements(mesh);
  return mesh;
}

/// Zero on the boundary, and the same in all eight symmetries of the square.
Vec2 symmetric_move(Vec2 x) {
  const auto bulge = [](double t) { return std::sin(pi * t) * std::sin(pi * t); };
  return 0.07 * Vec2{std::sin(2 * pi * x.x) * bulge(x.y), std::sin(2 * pi * x.y) * bulge(x.x)};
}

Vec2 skew_move(Vec2 x) { return 0.2 * x.x * (1 - x.x) * x.y * (1 - x.y) * Vec2{4 * x.y, 3 + x.x}; }

double least(const QuadMesh& mesh) {
  return *std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end());
}

double distance_to_set(Vec2 x, const std::vector<Vec2>& set) {
  double nearest = 1e300;
  for (const Vec2 y : set) nearest = std::min(nearest, distance(x, y));
  return nearest;
}

std::vector<int> boundary_nodes(const QuadMesh& mesh) {
  std::vector<int> nodes;
  const int n = mesh.order, width = n + 1;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    for (int k = 0; k <= n; ++k) {
      const int local[4] = {k, k * width + n, n * width + n - k, (n - k) * width};
      nodes.push_back(mesh.elem_nodes[e.elem * width * width + local[e.side]]);
    }
  return nodes;
}

TEST(Relax, RightensASkewMeshOfTheSquare) {
  for (const int order : {1, 2, 5}) {
    QuadMesh mesh = moved_square(order, skew_move);
    const double before = least(mesh);
    ASSERT_LT(before, 0.98);
    const RelaxOutcome outcome = relax(mesh, {50, 1e-6, {}});
    EXPECT_GT(outcome.sweeps, 0);
    EXPECT_LT(outcome.energy_after, outcome.energy_before);
    EXPECT_GT(outcome.largest_move, 0);
    EXPECT_GT(least(mesh), (1 + before) / 2) << order << ": half of what is missing at least";
    EXPECT_TRUE(mesh.is_valid);
  }
}

TEST(Relax, LeavesAPerfectMeshAlone) {
  QuadMesh mesh = moved_square(3, [](Vec2) { return Vec2{}; });
  const std::vector<Vec2> before = mesh.nodes;
  EXPECT_EQ(relax(mesh, {20, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(Relax, NeverMakesTheWorstWorseAndKeepsTheBoundaryOnItsCurves) {
  for (const int order : {1, 2, 4, 7})
    for (const SeparatrixGraph& graph : {hand_made::elbow(), hand_made::s_bend(), hand_made::cut_annulus(3)})
      for (const int sweeps : {1, 5, 40}) {
        const double tolerance = order == 1 ? 1e-2 : 1e-3;
        QuadMesh mesh = refined(graph, {0.4, order, tolerance});
        const double before = least(mesh);
        const std::vector<Vec2> joints = [&] {
          std::vector<Vec2> places;
          for (const Joint& joint : mesh.face.joints) places.push_back(joint.position);
          return places;
        }();
        std::vector<double> gaps;
        for (const Vec2 x : joints) gaps.push_back(distance_to_set(x, mesh.nodes));
        relax(mesh, {sweeps, tolerance * mesh.face.diameter, {}});
        EXPECT_GE(least(mesh), before - 1e-11);
        EXPECT_GT(mesh.least_jacobian_bound, 0);
        for (const int node : boundary_nodes(mesh)) {
          double nearest = 1e300;
          for (const Nurbs& curve : mesh.face.curves)
            nearest = std::min(nearest, curve::project(curve, mesh.nodes[node]).distance);
          EXPECT_LT(nearest, 1e-11);
        }
        for (std::size_t k = 0; k < joints.size(); ++k)
          if (gaps[k] < 1e-12 && mesh.face.joints[k].is_corner) {
            EXPECT_LT(distance_to_set(joints[k], mesh.nodes), 1e-12) << "corners stay";
          }
      }
}

TEST(Relax, SymmetricMeshesStaySymmetric) {
  for (const int order : {1, 2, 4}) {
    QuadMesh mesh = moved_square(order, symmetric_move);
    const double before = least(mesh);
    relax(mesh, {30, 1e-6, {}});
    EXPECT_GT(least(mesh), before);
    for (const Vec2 x : mesh.nodes)
      for (const Vec2 image : {Vec2{1 - x.x, x.y}, Vec2{x.x, 1 - x.y}, Vec2{x.y, x.x}, Vec2{1 - x.y, x.x}})
        EXPECT_LT(distance_to_set(image, mesh.nodes), 1e-11);
  }
}

TEST(Relax, FrozenElementsKeepTheirNodesBitForBit) {
  QuadMesh mesh = moved_square(3, skew_move);
  const QuadMesh before = mesh;
  std::vector<bool> frozen(mesh.num_elems(), false);
  for (const int elem : {5, 6, 7}) frozen[elem] = true;
  relax(mesh, {30, 1e-6, frozen});
  for (const int elem : {5, 6, 7}) EXPECT_EQ(element_nodes(mesh, elem), element_nodes(before, elem));
  EXPECT_NE(mesh.nodes, before.nodes) << "the others move";
}

TEST(Relax, NoSweepsAndMeshesThatAreNotValidChangeNothing) {
  QuadMesh mesh = moved_square(2, skew_move);
  const std::vector<Vec2> before = mesh.nodes;
  EXPECT_EQ(relax(mesh, {0, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
  mesh.is_valid = false;
  EXPECT_EQ(relax(mesh, {10, 1e-6, {}}).sweeps, 0);
  EXPECT_EQ(mesh.nodes, before);
}

TEST(Relax, GivesTheSameBytesTwice) {
  QuadMesh a = refined(hand_made::elbow(), {0.4, 4, 1e-4}), b = a;
  relax(a, {15, 1e-3, {}});
  relax(b, {15, 1e-3, {}});
  EXPECT_EQ(a.nodes, b.nodes);
}

}  // namespace
}  // namespace quadrille::refine
