#include <gtest/gtest.h>

#include <limits>

#include "../region_layout_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::block_layout(), damage);
}

TEST(BlockLayoutCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](BlockLayout&) {}), Rules{});
}

TEST(BlockLayoutCheck, BlkR01SplinesAreSound) {
  EXPECT_EQ(broken([](auto& b) { b.splines[0].degree = 3; }), Rules{"BLK-R01"});
}
TEST(BlockLayoutCheck, BlkR02NodesAndCurvesExist) {
  EXPECT_EQ(broken([](auto& b) { b.arcs[0].from = -1; }), Rules{"BLK-R02"});
}
TEST(BlockLayoutCheck, BlkR03PiecesAreSound) {
  EXPECT_EQ(broken([](auto& b) { b.arcs[0].pieces[0].t1 = 0; }), Rules{"BLK-R03"});
}
TEST(BlockLayoutCheck, BlkR04ArraysAgree) {
  EXPECT_EQ(broken([](auto& b) { b.block_names.pop_back(); }), Rules{"BLK-R04"});
  EXPECT_EQ(broken([](auto& b) { b.arc_chord.pop_back(); }), Rules{"BLK-R04"});
  EXPECT_EQ(broken([](auto& b) { b.block_scaled_jacobian.pop_back(); }), Rules{"BLK-R04"});
  EXPECT_EQ(broken([](auto& b) { b.block_boundary_distance[1] = std::numeric_limits<double>::infinity(); }),
            Rules{"BLK-R04"});
  EXPECT_EQ(broken([](auto& b) { b.block_scaled_jacobian.clear(), b.block_boundary_distance.clear(); }), Rules{})
      << "files of version 1.0 have neither";
  EXPECT_EQ(broken([](auto& b) { b.block_jacobian_bound[0] = std::numeric_limits<double>::quiet_NaN(); }),
            Rules{"BLK-R04"});
}
TEST(BlockLayoutCheck, BlkR05BlockIndicesExist) {
  EXPECT_EQ(broken([](auto& b) { b.block2nodes[0][2] = 6; }), Rules{"BLK-R05"});
  EXPECT_EQ(broken([](auto& b) { b.block2arcs[0][2] = {7, true}; }), Rules{"BLK-R05"});
  EXPECT_EQ(broken([](auto& b) { b.block2arcs[0][2] = half_edge_of_code(std::numeric_limits<int>::min()); }),
            Rules{"BLK-R05"});
  EXPECT_EQ(broken([](auto& b) { b.arc_chord[0] = -1; }), Rules{"BLK-R05"});
}
TEST(BlockLayoutCheck, BlkR06ArcsAreChains) {
  EXPECT_EQ(broken([](auto& b) { b.splines[0].poles[0] = {0.4, 0}; }), Rules{"BLK-R06"});
}
TEST(BlockLayoutCheck, BlkR07BoundaryIsCovered) {
  EXPECT_EQ(broken([](auto& b) { b.arcs[2].pieces.push_back(b.arcs[2].pieces[0]); }), (Rules{"BLK-R06", "BLK-R07"}));
}
TEST(BlockLayoutCheck, BlkR08NodeKindsFit) {
  EXPECT_EQ(broken([](auto& b) { b.nodes[5].kind = NodeKind::crossing; }), Rules{"BLK-R08"});
}
TEST(BlockLayoutCheck, BlkR09SidesJoinNodes) {
  EXPECT_TRUE(broken([](auto& b) { b.block2arcs[0][1] = {6, true}; }).contains("BLK-R09"));
}
TEST(BlockLayoutCheck, BlkR10ArcsAreShared) {
  EXPECT_EQ(broken([](auto& b) {
              b.block2nodes.push_back(b.block2nodes[0]);
              b.block2arcs.push_back(b.block2arcs[0]);
              b.block_jacobian_bound.push_back(1);
              b.block_scaled_jacobian.push_back(1);
              b.block_boundary_distance.push_back(0);
              b.block_names.push_back("again");
            }),
            (Rules{"BLK-R10", "BLK-R13", "BLK-R14"}));
}
TEST(BlockLayoutCheck, BlkR11ChordsLinkOppositeSides) {
  EXPECT_EQ(broken([](auto& b) { b.arc_chord[0] = 3; }), Rules{"BLK-R11"});
}
TEST(BlockLayoutCheck, BlkR12NamesAreThere) {
  EXPECT_EQ(broken([](auto& b) { b.block_names[1] = b.block_names[0]; }), Rules{}) << "two blocks of one region";
  EXPECT_EQ(broken([](auto& b) { b.block_names[1] = ""; }), Rules{"BLK-R12"});
}
TEST(BlockLayoutCheck, BlkR13EulerCount) {
  EXPECT_EQ(broken([](auto& b) {  // a node of its own, with valence 4, adds nothing to the index sum
              b.nodes.push_back({{0.25, 0.5}, NodeKind::crossing, 4, -1, 0});
            }),
            (Rules{"BLK-R13", "BLK-R14"}));
}
TEST(BlockLayoutCheck, BlkR14ValencesAreBlocks) {
  EXPECT_EQ(broken([](auto& b) {
              b.nodes[0].valence = 2;
              b.nodes[1].valence = 0;
            }),
            Rules{"BLK-R14"});
}
TEST(BlockLayoutCheck, BlkR16BlocksLieInOneRegion) {
  const auto broken_regions = [](const auto& damage) { return broken_rules(samples::two_regions_layout(), damage); };
  EXPECT_EQ(broken_regions([](auto&) {}), Rules{});
  EXPECT_EQ(broken_regions([](auto& b) { b.block_region = {1, 0}; }), Rules{"BLK-R16"});
  EXPECT_EQ(broken_regions([](auto& b) { b.block_region.clear(); }), Rules{"BLK-R16"});
  EXPECT_EQ(broken([](auto& b) { b.block_region = {0, 0}; }), Rules{}) << "needless, but true";
  EXPECT_EQ(broken([](auto& b) { b.block_region = {0, 1}; }), Rules{"BLK-R16"});
}
TEST(BlockLayoutCheck, BlkR17InterfacesThatAreNotOpenAreShared) {
  const auto broken_open = [](const auto& damage) { return broken_rules(samples::open_regions_layout(), damage); };
  EXPECT_EQ(broken_open([](auto&) {}), Rules{});
  EXPECT_EQ(broken_open([](auto& b) { b.open_curves.clear(); }), Rules{"BLK-R17"}) << "two nodes in one place";
  EXPECT_EQ(broken_open([](auto& b) { b.open_curves = {7}; }), Rules{"BLK-R17"}) << "the other side is missing";
  EXPECT_EQ(broken_open([](auto& b) { b.open_curves = {1, 7, 7}; }), Rules{"BLK-R17"});
  const auto open_what_is_shared = [](auto& b) { b.open_curves = {1, 7}; };
  EXPECT_EQ(broken_rules(samples::two_regions_layout(), open_what_is_shared), Rules{"BLK-R17"});
}
TEST(BlockLayoutCheck, BlkR15IndexSum) {
  EXPECT_EQ(broken([](auto& b) { b.nodes[0].valence = 2; }), (Rules{"BLK-R14", "BLK-R15"}));
}

}  // namespace
}  // namespace quadrille::check
