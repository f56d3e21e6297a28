#include "refine/inner_edges.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "refine/validity.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

QuadMesh curved_mesh(const SeparatrixGraph& graph, double size, int order) {
  return refined(graph, {.size = size, .order = order, .geometry_tol = 1e-3, .inner_edges = InnerEdges::curved});
}

QuadMesh shaped(QuadMesh mesh, InnerEdges shape, const std::vector<bool>& kept = {}) {
  shape_inner_edges(mesh, shape, kept);
  return mesh;
}

std::vector<bool> are_on_curves(const QuadMesh& mesh) {
  std::vector<bool> on_curve(4 * mesh.num_elems(), false);
  for (const auto* edges : {&mesh.boundary_edges, &mesh.interface_edges})
    for (const QuadBoundaryEdge& e : *edges) on_curve[4 * e.elem + e.side] = true;
  return on_curve;
}

/// Greatest distance of a side's nodes from its chord, over the length of the chord.
double bend(const QuadMesh& mesh, int elem, int side) {
  const std::vector<int> nodes = side_nodes(mesh, elem, side);
  const Vec2 from = mesh.nodes[nodes.front()], to = mesh.nodes[nodes.back()];
  double greatest = 0;
  for (std::size_t k = 0; k < nodes.size(); ++k) {
    const double t = (1 + spectral::gll_points(mesh.order)[k]) / 2;
    greatest = std::max(greatest, distance(mesh.nodes[nodes[k]], (1 - t) * from + t * to));
  }
  return greatest / distance(from, to);
}

/// Greatest bend of the sides on no CAD curve.
double inner_bend(const QuadMesh& mesh) {
  const std::vector<bool> on_curve = are_on_curves(mesh);
  double greatest = 0;
  for (int i = 0; i < 4 * mesh.num_elems(); ++i)
    if (!on_curve[i]) greatest = std::max(greatest, bend(mesh, i / 4, i % 4));
  return greatest;
}

TEST(InnerEdges, AreStraightAndThoseOnCurvesStayBitForBit) {
  const QuadMesh before = curved_mesh(hand_made::quarter_annulus(), 0.2, 4);
  EXPECT_GT(inner_bend(before), 1e-3);
  const QuadMesh after = shaped(before, InnerEdges::straight);
  EXPECT_LT(inner_bend(after), 1e-12);
  const std::vector<bool> on_curve = are_on_curves(after);
  for (int i = 0; i < 4 * after.num_elems(); ++i)
    if (on_curve[i]) {
      for (const int node : side_nodes(after, i / 4, i % 4)) EXPECT_EQ(after.nodes[node], before.nodes[node]);
    }
  EXPECT_TRUE(after.is_valid);
}

TEST(InnerEdges, ElementsInsideAreBilinear) {
  const QuadMesh mesh = shaped(curved_mesh(hand_made::quarter_annulus(), 0.2, 3), InnerEdges::straight);
  const std::vector<bool> on_curve = are_on_curves(mesh);
  const std::vector<double>& xi = spectral::gll_points(3);
  int num_inside = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    if (std::any_of(on_curve.begin() + 4 * elem, on_curve.begin() + 4 * elem + 4, [](bool on) { return on; })) continue;
    ++num_inside;
    const std::vector<Vec2> x = element_nodes(mesh, elem);
    for (int k = 0; k < 16; ++k) {
      const double s = (1 + xi[k % 4]) / 2, t = (1 + xi[k / 4]) / 2;
      const Vec2 bilinear = (1 - t) * ((1 - s) * x[0] + s * x[3]) + t * ((1 - s) * x[12] + s * x[15]);
      EXPECT_LT(distance(x[k], bilinear), 1e-12);
    }
  }
  EXPECT_GT(num_inside, 4);
}

TEST(InnerEdges, CurvatureOfTheBoundaryFadesWithTheSquareWithinOneRow) {
  const QuadMesh mesh = shaped(curved_mesh(hand_made::quarter_annulus(), 0.2, 3), InnerEdges::straight);
  const std::vector<bool> on_curve = are_on_curves(mesh);
  const std::vector<double>& xi = spectral::gll_points(3);
  int num_checked = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    if (on_curve[4 * elem] || !on_curve[4 * elem + 1] || on_curve[4 * elem + 2] || on_curve[4 * elem + 3]) continue;
    ++num_checked;
    const std::vector<Vec2> x = element_nodes(mesh, elem);
    for (int k = 0; k < 16; ++k) {
      const double s = (1 + xi[k % 4]) / 2, t = (1 + xi[k / 4]) / 2;
      const Vec2 bilinear = (1 - t) * ((1 - s) * x[0] + s * x[3]) + t * ((1 - s) * x[12] + s * x[15]);
      const Vec2 shift = x[k / 4 * 4 + 3] - ((1 - t) * x[3] + t * x[15]);
      EXPECT_LT(distance(x[k], bilinear + s * s * shift), 1e-12);
    }
  }
  EXPECT_GT(num_checked, 1);
}

TEST(InnerEdges, KeepTheirCurveWhereElementsWouldBecomeTooSkew) {
  // Wide elements between two arcs: their chords cut through the next row.
  const QuadMesh before = refined(
      hand_made::quarter_annulus(),
      {.size = 1, .order = 6, .geometry_tol = 0.5, .counts = {{0, 8}, {1, 1}}, .inner_edges = InnerEdges::curved});
  ASSERT_TRUE(before.is_valid);
  const QuadMesh after = shaped(before, InnerEdges::straight);
  EXPECT_TRUE(after.is_valid);
  EXPECT_GT(inner_bend(after), 1e-3) << "else this shows nothing";
  for (int elem = 0; elem < after.num_elems(); ++elem)
    EXPECT_GE(after.elem_scaled_jacobian[elem], std::min(0.6, before.elem_scaled_jacobian[elem]) - 1e-6);
}

TEST(InnerEdges, ElementsThatAreKeptDoNotChange) {
  const QuadMesh before = curved_mesh(hand_made::quarter_annulus(), 0.2, 4);
  std::vector<bool> kept(before.num_elems(), false);
  kept[3] = true;
  const QuadMesh after = shaped(before, InnerEdges::straight, kept);
  EXPECT_EQ(element_nodes(after, 3), element_nodes(before, 3));
  EXPECT_NE(after.nodes, before.nodes);
  EXPECT_EQ(shaped(before, InnerEdges::straight, std::vector<bool>(before.num_elems(), true)).nodes, before.nodes);
}

TEST(InnerEdges, FadeByHalfFromRowToRow) {
  const QuadMesh before = curved_mesh(hand_made::quarter_annulus(), 0.1, 4);
  const QuadMesh after = shaped(before, InnerEdges::fade);
  std::vector<double> factors;
  const std::vector<bool> on_curve = are_on_curves(after);
  for (int i = 0; i < 4 * after.num_elems(); ++i)
    if (!on_curve[i] && bend(before, i / 4, i % 4) > 1e-6)
      factors.push_back(bend(after, i / 4, i % 4) / bend(before, i / 4, i % 4));
  ASSERT_FALSE(factors.empty());
  for (const double factor : factors) EXPECT_NEAR(std::log2(factor), std::round(std::log2(factor)), 1e-6);
  EXPECT_NEAR(std::ranges::max(factors), 0.5, 1e-6);
  EXPECT_LT(std::ranges::min(factors), 0.3);
}

TEST(InnerEdges, MeasuresAreThoseOfTheNewElements) {
  QuadMesh mesh = shaped(curved_mesh(hand_made::quarter_annulus(), 0.2, 4), InnerEdges::straight);
  const QuadMesh found = mesh;
  measure_elements(mesh);
  EXPECT_EQ(found.elem_jacobian_bound, mesh.elem_jacobian_bound);
  EXPECT_EQ(found.elem_scaled_jacobian, mesh.elem_scaled_jacobian);
  EXPECT_EQ(found.least_jacobian_bound, mesh.least_jacobian_bound);
}

TEST(InnerEdges, OfOrderOneHaveNothingToChange) {
  const QuadMesh before = curved_mesh(hand_made::quarter_annulus(), 0.2, 1);
  EXPECT_EQ(shaped(before, InnerEdges::straight).nodes, before.nodes);
}

}  // namespace
}  // namespace quadrille::refine
