#include "refine/tip_rings.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../samples.hpp"
#include "check/check.hpp"
#include "mesh/element_sizes.hpp"
#include "refine/refine.hpp"
#include "refine/validity.hpp"

namespace quadrille::refine {
namespace {

/// The unit square, of two blocks.
QuadMesh square(int order) {
  RefineOptions options;
  options.order = order;
  options.size = 0.1;
  options.geometry_tol = 0.1;
  Report report;
  return refine(samples::block_layout(), options, report);
}

int node_at(const QuadMesh& mesh, Vec2 x) {
  const auto nearest =
      std::ranges::min_element(mesh.nodes, {}, [&](Vec2 node) { return distance(node, x); }) - mesh.nodes.begin();
  return static_cast<int>(nearest);
}

double longest_edge_at(const QuadMesh& mesh, Vec2 x) {
  double longest = 0;
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const Vec2 a = mesh.nodes[side_start(mesh, elem, side)], b = mesh.nodes[side_start(mesh, elem, (side + 1) % 4)];
      if (std::min(distance(a, x), distance(b, x)) < 1e-12) longest = std::max(longest, distance(a, b));
    }
  return longest;
}

void measure(QuadMesh& mesh) {
  measure_elements(mesh);
  mesh::measure_element_sizes(mesh);
}

TEST(TipRings, ElementsAtACornerAreHalvedByEachRing) {
  for (const int order : {1, 2, 4})
    for (const int width : {1, 2, 3}) {
      const QuadMesh before = square(order);
      const double length = longest_edge_at(before, {1, 0});
      std::optional<QuadMesh> mesh = with_tip_rings(before, node_at(before, {1, 0}), {width, 5});
      ASSERT_TRUE(mesh.has_value());
      measure(*mesh);
      EXPECT_EQ(mesh->num_elems(), before.num_elems() + 5 * 2 * width);
      EXPECT_EQ(mesh->num_irregular, before.num_irregular + 2);
      EXPECT_NEAR(longest_edge_at(*mesh, {1, 0}), length / 32, 1e-9);
      EXPECT_GT(least_scaled_jacobian(*mesh), 0.7);
      for (const check::Violation& v : check::check_stage(*mesh, check::CheckDepth::full))
        ADD_FAILURE() << v.rule << ": " << v.text;
    }
}

TEST(TipRings, ElementsElsewhereKeepTheirNodes) {
  const QuadMesh before = square(3);
  const std::optional<QuadMesh> mesh = with_tip_rings(before, node_at(before, {0, 0}), {2, 3});
  ASSERT_TRUE(mesh.has_value());
  for (int elem = 0; elem < before.num_elems(); ++elem) {
    if (norm(mesh::centre(before, elem)) < 0.5) continue;
    EXPECT_EQ(element_nodes(before, elem), element_nodes(*mesh, elem));
  }
}

TEST(TipRings, MirrorImagesAgree) {
  const QuadMesh before = square(4);
  std::vector<std::vector<double>> sorted;
  for (const Vec2 corner : {Vec2{0, 0}, Vec2{1, 0}}) {
    std::optional<QuadMesh> mesh = with_tip_rings(before, node_at(before, corner), {2, 4});
    ASSERT_TRUE(mesh.has_value());
    measure(*mesh);
    std::ranges::sort(mesh->elem_scaled_jacobian);
    sorted.push_back(mesh->elem_scaled_jacobian);
  }
  for (std::size_t k = 0; k < sorted[0].size(); ++k) EXPECT_NEAR(sorted[0][k], sorted[1][k], 1e-9);
}

// Two blocks meet at (0.5, 0): a ray between them.
TEST(TipRings, RingsOfSeveralBlocksConform) {
  const QuadMesh before = square(2);
  std::optional<QuadMesh> mesh = with_tip_rings(before, node_at(before, {0.5, 0}), {1, 4});
  ASSERT_TRUE(mesh.has_value());
  measure(*mesh);
  EXPECT_EQ(mesh->num_elems(), before.num_elems() + 4 * 2 * 2);
  EXPECT_EQ(mesh->num_irregular, before.num_irregular + 4);
  EXPECT_TRUE(mesh->is_valid);
  for (const check::Violation& v : check::check_stage(*mesh, check::CheckDepth::full))
    ADD_FAILURE() << v.rule << ": " << v.text;
}

TEST(TipRings, ThereMustBeRoom) {
  const QuadMesh mesh = square(2);
  EXPECT_FALSE(with_tip_rings(mesh, node_at(mesh, {0, 0}), {20, 1}).has_value());
}

}  // namespace
}  // namespace quadrille::refine
