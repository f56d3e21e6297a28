// The rules of separatrix graphs, block layouts and quad meshes for faces of several regions.

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/refined.hpp"
#include "../support/region_graphs.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

using region_graphs::disc_in_square, region_graphs::slit_plate, region_graphs::two_squares;

template <typename Damage>
Rules broken(SeparatrixGraph graph, const Damage& damage) {
  return broken_rules(std::move(graph), damage);
}

BlockLayout layout_of(const SeparatrixGraph& graph) {
  Report report;
  return block::extract_blocks(graph, report);
}

template <typename Damage>
Rules broken_layout(const SeparatrixGraph& graph, const Damage& damage) {
  return broken_rules(layout_of(graph), damage);
}

template <typename Damage>
Rules broken_mesh(const SeparatrixGraph& graph, const Damage& damage) {
  return broken_rules(refined(graph, {.size = 0.5, .order = 3}), damage);
}

const auto nothing = [](auto&) {};

TEST(RegionRules, GraphsAndWhatIsMadeOfThemAreValid) {
  for (const SeparatrixGraph& graph : {two_squares(), disc_in_square(), slit_plate(false), slit_plate(true)}) {
    EXPECT_EQ(broken(graph, nothing), Rules{});
    EXPECT_EQ(broken_layout(graph, nothing), Rules{});
    EXPECT_EQ(broken_mesh(graph, nothing), Rules{});
  }
}

TEST(RegionRules, SepR04InnerArcsFollowTheFirstSideOfAnInterface) {
  EXPECT_EQ(broken(two_squares(), [](auto& g) { g.arcs[1].pieces[0] = {7, 1, 0}; }), Rules{"SEP-R04"});
  EXPECT_EQ(broken(two_squares(), [](auto& g) { g.arcs[0].is_boundary = false; }), Rules{"SEP-R04"});
}

TEST(RegionRules, SepR06InterfacesAreCoveredOnce) {
  EXPECT_TRUE(broken(slit_plate(false), [](auto& g) { g.arcs.pop_back(); }).contains("SEP-R06"));
  EXPECT_TRUE(broken(slit_plate(true), [](auto& g) { g.arcs.pop_back(); }).contains("SEP-R06"));
  EXPECT_TRUE(broken(two_squares(), [](auto& g) { g.arcs[1].is_boundary = true; }).contains("SEP-R06"));
  EXPECT_TRUE(broken(two_squares(), [](auto& g) { g.arcs.push_back(g.arcs[1]); }).contains("SEP-R06"));
  EXPECT_TRUE(broken(slit_plate(false), [](auto& g) {
                g.arcs.push_back(g.arcs.back());
                g.arcs.back().is_boundary = true;
              }).contains("SEP-R06"));
}

TEST(RegionRules, SepR07NodesOfInterfacesNameTheirCurve) {
  EXPECT_EQ(broken(disc_in_square(), [](auto& g) { g.nodes[4].curve = 0; }).contains("SEP-R07"), true);
  EXPECT_EQ(broken(disc_in_square(), [](auto& g) { g.nodes[8].kind = NodeKind::interface; }), Rules{"SEP-R07"});
}

TEST(RegionRules, SepR09AnInterfaceNodeHasAsManyArcsAsItsValence) {
  EXPECT_EQ(broken(disc_in_square(), [](auto& g) { g.nodes[4].valence = 5; }), Rules{"SEP-R09"});
}

TEST(RegionRules, SepR12TheIndexSumIsThatOfTheWhole) {
  const auto certify = [](auto& g) {
    g.certificate.method = LayoutMethod::traced;
    g.certificate.index_sum = 4;
    g.certificate.face_valence_histogram = {{4, 9}};
  };
  EXPECT_EQ(broken(disc_in_square(), certify), Rules{});
  EXPECT_EQ(broken(disc_in_square(),
                   [&](auto& g) {
                     certify(g);
                     g.certificate.index_sum = 8;
                   }),
            Rules{"SEP-R12"});
}

TEST(RegionRules, BlkR16BlocksLieInOneRegion) {
  EXPECT_EQ(broken_layout(two_squares(), [](auto& b) { b.block_region = {1, 0}; }), Rules{"BLK-R16"});
  EXPECT_EQ(broken_layout(disc_in_square(), [](auto& b) { b.block_region.clear(); }), Rules{"BLK-R16"});
  EXPECT_EQ(broken_layout(disc_in_square(), [](auto& b) { b.block_region[0] = 1 - b.block_region[0]; }),
            Rules{"BLK-R16"});
  EXPECT_EQ(broken_layout(hand_made::unit_square(), [](auto& b) { b.block_region = {0, 0}; }), Rules{"BLK-R16"});
}

TEST(RegionRules, QuaR06EdgesFollowTheLoopsOfEachRegion) {
  EXPECT_TRUE(broken_mesh(two_squares(), [](auto& m) { m.interface_edges.clear(); }).contains("QUA-R06"));
  EXPECT_TRUE(broken_mesh(two_squares(), [](auto& m) {
                std::reverse(m.interface_edges.begin(), m.interface_edges.end());
              }).contains("QUA-R06"));
}

TEST(RegionRules, QuaR12BothSidesOfAnInterfaceAreNamed) {
  EXPECT_TRUE(broken_mesh(disc_in_square(), [](auto& m) { m.interface_edges.pop_back(); }).contains("QUA-R12"));
  EXPECT_TRUE(broken_mesh(two_squares(), [](auto& m) { m.interface_edges[0].curve = 0; }).contains("QUA-R12"));
}

TEST(RegionRules, QuaR13NoBlockLiesInTwoRegions) {
  EXPECT_EQ(broken_mesh(two_squares(), [](auto& m) { m.block_region = {1, 0}; }), Rules{"QUA-R13"});
  EXPECT_EQ(broken_mesh(two_squares(), [](auto& m) { m.block_region.pop_back(); }), Rules{"QUA-R13"});
  EXPECT_EQ(broken_mesh(disc_in_square(), [](auto& m) { m.elem_block[0] = m.elem_block.back(); }), Rules{"QUA-R13"});
}

}  // namespace
}  // namespace quadrille::check
