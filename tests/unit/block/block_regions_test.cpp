// Blocks of several regions: their regions, their names, and cuts through interfaces.

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/region_graphs.hpp"
#include "block/extract_blocks.hpp"
#include "block/make_blocks.hpp"
#include "block_samples.hpp"
#include "model/interfaces.hpp"

namespace quadrille::block {
namespace {

Vec2 centre(const BlockLayout& layout, int block) {
  Vec2 sum;
  for (const int node : layout.block2nodes[block]) sum += 0.25 * layout.nodes[node].position;
  return sum;
}

TEST(BlockRegions, InterfacesBoundTheRegions) {
  const BlockLayout disc = extract_blocks(region_graphs::disc_in_square());
  ASSERT_EQ(disc.num_blocks(), 9);
  for (int b = 0; b < 9; ++b) EXPECT_EQ(disc.block_region[b], norm(centre(disc, b)) < 0.9 ? 1 : 0);
  EXPECT_EQ(std::count(disc.block_region.begin(), disc.block_region.end(), 1), 5);
  const BlockLayout squares = extract_blocks(region_graphs::two_squares());
  for (int b = 0; b < 2; ++b) EXPECT_EQ(squares.block_region[b], centre(squares, b).x < 1 ? 0 : 1);
}

TEST(BlockRegions, OneRegionHasNone) {
  EXPECT_TRUE(extract_blocks(hand_made::unit_square()).block_region.empty());
  EXPECT_TRUE(extract_blocks(region_graphs::slit_plate(false)).block_region.empty());
}

TEST(BlockRegions, BlocksHaveTheNameOfTheirRegion) {
  BlockLayout disc = extract_blocks(region_graphs::disc_in_square());
  disc.face.name = "assembly";
  disc.face.region_names = {"plate", "disc"};
  name_blocks(disc, {});
  EXPECT_TRUE(disc.unnamed_blocks.empty());
  for (int b = 0; b < 9; ++b) EXPECT_EQ(disc.block_names[b], disc.block_region[b] == 1 ? "disc" : "plate");
}

TEST(BlockRegions, ACutThroughAnInterfaceStaysOnIt) {
  graph::Subdivision subdivision = subdivision_into_blocks(region_graphs::disc_in_square());
  const auto on_circle = [&](int a) { return is_on_interface(subdivision.graph(), subdivision.graph().arcs[a]); };
  int arc = 0;
  while (!on_circle(arc)) ++arc;
  const int num_nodes = subdivision.node_bound();
  ASSERT_TRUE(split_chord(subdivision, arc, std::vector<bool>(9, true)));
  int num_on_circle = 0;
  for (int n = num_nodes; n < subdivision.node_bound(); ++n) {
    const GraphNode& node = subdivision.graph().nodes[n];
    if (node.kind != NodeKind::interface) continue;
    ++num_on_circle;
    EXPECT_EQ(node.valence, 4);
    EXPECT_EQ(node.curve, 4);
    EXPECT_NEAR(norm(node.position), 1, 1e-13);
    EXPECT_LT(distance(curve::point(subdivision.graph().face.curves[4], node.t), node.position), 1e-13);
  }
  EXPECT_EQ(num_on_circle, 2) << "the chord crosses the circle twice";
  BlockLayout cut = blocks_of(subdivision);
  store_measures(measure_blocks(cut), cut);
  EXPECT_EQ(block_samples::faults(cut), "");
}

TEST(BlockRegions, MeasuresSeeInterfaces) {
  Report report;
  const Blocks disc = make_blocks(region_graphs::disc_in_square(), report);
  double greatest = 0;
  for (const double d : disc.layout.block_boundary_distance) greatest = std::max(greatest, d);
  EXPECT_GT(greatest, 0) << "polynomials are not exactly circles";
  EXPECT_LT(greatest, 1e-6);
}

}  // namespace
}  // namespace quadrille::block
