#include "refine/tip_patch.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../samples.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

/// The unit square, of two blocks, in 10 x 10 elements of order 2.
struct Square : testing::Test {
  static QuadMesh meshed() {
    Report report;
    return refine(samples::block_layout(), {.size = 0.1, .order = 2, .geometry_tol = 0.1}, report);
  }
  QuadMesh mesh = meshed();
  std::map<QuadSide, int> curves = [this] {
    std::map<QuadSide, int> of;
    for (const QuadBoundaryEdge& e : mesh.boundary_edges) of[{e.elem, e.side}] = e.curve;
    return of;
  }();

  int node_at(Vec2 x) const {
    const auto nearest = std::ranges::min_element(mesh.nodes, {}, [&](Vec2 node) { return distance(node, x); });
    EXPECT_LT(distance(*nearest, x), 1e-12);
    return static_cast<int>(nearest - mesh.nodes.begin());
  }
  std::vector<TipPatch> patches_at(Vec2 x, int width) const { return tip_patches(mesh, node_at(x), width, curves); }
};
using TipPatches = Square;

TEST_F(TipPatches, CountFromTheTip) {
  const std::vector<TipPatch> patches = patches_at({1, 0}, 2);
  ASSERT_EQ(patches.size(), 1U);
  const auto at = [&](int i, int j) { return mesh.nodes[patches[0].vertex(i, j)]; };
  EXPECT_EQ(distance(at(0, 0), {1, 0}), 0);
  EXPECT_EQ(at(0, 2).y, 0) << "the side that ends at the corner";
  EXPECT_EQ(at(2, 0).x, 1) << "the side that starts there";
  EXPECT_EQ(patches[0].outer_vertex(2), patches[0].vertex(2, 2));
  EXPECT_EQ(curves.at(patches[0].wall_edge(true, 1)), 1);
  EXPECT_EQ(curves.at(patches[0].wall_edge(false, 1)), 0);
}

TEST_F(TipPatches, OuterEdgesJoinOuterVertices) {
  const std::vector<TipPatch> patches = patches_at({0, 1}, 3);
  ASSERT_EQ(patches.size(), 1U);
  for (int k = 0; k < 6; ++k) {
    const auto [elem, side] = patches[0].outer_edge(k);
    EXPECT_EQ(side_start(mesh, elem, side), patches[0].outer_vertex(k)) << k;
    EXPECT_EQ(side_start(mesh, elem, (side + 1) % 4), patches[0].outer_vertex(k + 1)) << k;
    EXPECT_FALSE(curves.contains({elem, side}));
  }
}

/// At a node on a side there are two, inside there are four.
TEST_F(TipPatches, EachSectorHasOne) {
  const std::vector<TipPatch> on_side = patches_at({0.5, 0}, 2);
  ASSERT_EQ(on_side.size(), 2U);
  std::set<int> elems;
  for (int j = 0; j < 2; ++j)
    for (int i = 0; i < 2; ++i) elems.insert(on_side[0].cell(i, j).elem);
  EXPECT_TRUE(on_side[0].contains_any(elems));
  EXPECT_FALSE(on_side[1].contains_any(elems));
  EXPECT_EQ(patches_at({0.5, 0.5}, 2).size(), 4U);
}

TEST_F(TipPatches, NeedARowAndAColumnMore) {
  EXPECT_EQ(patches_at({0, 0}, 9).size(), 1U);
  EXPECT_TRUE(patches_at({0, 0}, 10).empty());
  EXPECT_TRUE(patches_at({0.5, 0}, 5).empty()) << "one of two has no room";
}

TEST_F(TipPatches, HaveOneCurveOnEachSide) {
  for (auto& [side, curve] : curves) {
    const Vec2 start = mesh.nodes[side_start(mesh, side.first, side.second)];
    if (curve == 0 && start.x > 0.15) curve = 7;  // another curve goes on from (0.2, 0)
  }
  EXPECT_EQ(patches_at({0, 0}, 2).size(), 1U);
  EXPECT_TRUE(patches_at({0, 0}, 3).empty());
}

TEST_F(TipPatches, DoNotTouchInterfaces) {
  const TipPatch::Cell far = patches_at({0, 0}, 3)[0].cell(2, 2);
  mesh.interface_edges.push_back({far.elem, 0, 0});
  EXPECT_EQ(patches_at({0, 0}, 2).size(), 1U);
  EXPECT_TRUE(patches_at({0, 0}, 3).empty());
}

}  // namespace
}  // namespace quadrille::refine
