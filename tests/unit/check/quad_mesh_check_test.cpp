#include <gtest/gtest.h>

#include <limits>

#include "../region_layout_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::quad_mesh(), damage);
}

TEST(QuadMeshCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](QuadMesh&) {}), Rules{});
}

TEST(QuadMeshCheck, QuaR01ArraysAgree) {
  EXPECT_EQ(broken([](auto& m) { m.order = 2; }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.order = -1; }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.elem_jacobian_bound.pop_back(); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.unnamed_blocks = {2}; }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.unnamed_blocks = {1, 0}; }), Rules{"QUA-R01"});
}
TEST(QuadMeshCheck, QuaR02IndicesExist) {
  EXPECT_EQ(broken([](auto& m) { m.elem_nodes[3] = 6; }), Rules{"QUA-R02"});
  EXPECT_EQ(broken([](auto& m) { m.elem_block[1] = 2; }), Rules{"QUA-R02"});
  EXPECT_EQ(broken([](auto& m) { m.boundary_edges[1].side = 4; }), Rules{"QUA-R02"});
}
TEST(QuadMeshCheck, QuaR03NumbersAreFinite) {
  EXPECT_EQ(broken([](auto& m) { m.nodes[3].y = std::numeric_limits<double>::quiet_NaN(); }), Rules{"QUA-R03"});
}
TEST(QuadMeshCheck, QuaR04StoredBoundsArePositive) {
  EXPECT_EQ(broken([](auto& m) { m.least_jacobian_bound = m.elem_jacobian_bound[1] = 0; }), Rules{"QUA-R04"});
  EXPECT_EQ(broken([](auto& m) { m.elem_scaled_jacobian[1] = 1.5; }), Rules{"QUA-R04"});
}
TEST(QuadMeshCheck, QuaR05MeshIsConforming) {
  EXPECT_TRUE(broken([](auto& m) {  // the right element gets nodes of its own on the common side
                m.nodes.push_back(m.nodes[1]);
                m.elem_nodes[4] = 6;
              })
                  .contains("QUA-R05"));
}
TEST(QuadMeshCheck, QuaR06BoundaryWalksTheLoops) {
  EXPECT_EQ(broken([](auto& m) { std::swap(m.boundary_edges[0], m.boundary_edges[1]); }), Rules{"QUA-R06"});
}
TEST(QuadMeshCheck, QuaR07EulerCount) {
  EXPECT_EQ(broken([](auto& m) { m.nodes.push_back({0.3, 0.3}); }), Rules{"QUA-R07"});
}
TEST(QuadMeshCheck, QuaR08IrregularNodesAgree) {
  EXPECT_EQ(broken([](auto& m) { m.num_irregular = 1; }), Rules{"QUA-R08"});
}
TEST(QuadMeshCheck, QuaR10RootTellsValidity) {
  EXPECT_EQ(broken([](auto& m) { m.least_jacobian_bound = 0.1; }), Rules{"QUA-R10"});
  EXPECT_EQ(broken([](auto& m) { m.is_valid = false; }), Rules{"QUA-R10"});
}

TEST(QuadMeshCheck, QuaR11SizesAreInRange) {
  EXPECT_EQ(broken([](auto& m) { m.elem_edge_ratio[1] = 0.5; }), Rules{"QUA-R11"});
  EXPECT_EQ(broken([](auto& m) { m.elem_area_jump[0] = 0; }), Rules{"QUA-R11"});
  EXPECT_EQ(broken([](auto& m) { m.elem_node_distance[1] = 0; }), Rules{"QUA-R11"});
  EXPECT_EQ(broken([](auto& m) { m.elem_prescribed_length[1] = -1; }), Rules{"QUA-R11"});
  EXPECT_EQ(broken([](auto& m) { m.elem_prescribed_length.pop_back(); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.elem_prescribed_stretch.assign(1, {}); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.elem_prescribed_stretch = {{}, {2, 0, 2}}; }), Rules{"QUA-R11"});
  EXPECT_EQ(broken([](auto& m) { m.elem_area_jump.pop_back(); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) { m.elem_edge_ratio.clear(); }), Rules{"QUA-R01"});
  EXPECT_EQ(broken([](auto& m) {  // a file of version 1.2
              m.elem_edge_ratio.clear();
              m.elem_area_jump.clear();
              m.elem_node_distance.clear();
            }),
            Rules{});
}

template <typename Damage>
Rules broken_regions(const Damage& damage) {
  return broken_rules(samples::two_regions_quads(), damage);
}

TEST(QuadMeshCheck, QuaR12InterfacesAreNamedFromBothSides) {
  EXPECT_EQ(broken_regions([](auto&) {}), Rules{});
  EXPECT_EQ(broken_regions([](auto& m) { m.interface_edges[0].curve = 0; }), Rules{"QUA-R12"});
  EXPECT_EQ(broken_regions([](auto& m) { m.interface_edges.pop_back(); }), (Rules{"QUA-R06", "QUA-R12"}));
  EXPECT_EQ(broken_regions([](auto& m) { m.interface_edges[0].elem = 2; }), Rules{"QUA-R02"});
}
TEST(QuadMeshCheck, QuaR13BlocksLieInOneRegion) {
  EXPECT_EQ(broken_regions([](auto& m) { m.block_region = {1, 0}; }), Rules{"QUA-R13"});
  EXPECT_EQ(broken_regions([](auto& m) { m.block_region.clear(); }), Rules{"QUA-R13"});
  EXPECT_EQ(broken([](auto& m) { m.block_region = {0, 1}; }), Rules{"QUA-R13"});
}

TEST(QuadMeshCheck, QuaR14InterfacesThatAreNotOpenAreShared) {
  const auto broken_open = [](const auto& damage) { return broken_rules(samples::open_regions_quads(), damage); };
  EXPECT_EQ(broken_open([](auto&) {}), Rules{});
  EXPECT_EQ(broken_open([](auto& m) { m.open_curves.clear(); }), Rules{"QUA-R14"}) << "two nodes in one place";
  EXPECT_EQ(broken_open([](auto& m) { m.open_curves = {1}; }), Rules{"QUA-R14"}) << "the other side is missing";
  EXPECT_EQ(broken_open([](auto& m) { m.open_curves = {0, 1, 7}; }), Rules{"QUA-R14"}) << "a boundary";
  EXPECT_EQ(broken_open([](auto& m) { m.open_curves = {1, 8}; }), Rules{"QUA-R14"});
  EXPECT_EQ(broken_regions([](auto& m) { m.open_curves = {1, 7}; }), Rules{"QUA-R14"}) << "its edges are shared";
}

TEST(QuadMeshCheck, AMeshThatSaysItIsNotValidKeepsTheRules) {
  const auto folded = [](QuadMesh& m) {
    m.nodes[4] = {-0.1, 0.4};
    m.elem_jacobian_bound[0] = m.least_jacobian_bound = -0.1;
    m.elem_scaled_jacobian[0] = -1;
  };
  EXPECT_EQ(broken(folded), Rules{"QUA-R04"});
  const auto marked = [&](QuadMesh& m) {
    folded(m);
    m.is_valid = false;
  };
  EXPECT_EQ(broken(marked), Rules{});
  const auto with_another = [&](QuadMesh& m) {  // an element that is said to be valid must be
    marked(m);
    m.nodes[5] = {0, 0.1};
  };
  EXPECT_EQ(broken(with_another), Rules{"QUA-R09"});
}

TEST(QuadMeshCheck, DoubtNamesTheWorstElement) {
  QuadMesh mesh = samples::quad_mesh();
  EXPECT_EQ(validity_warning(mesh), "");
  mesh.is_valid = false;
  mesh.elem_jacobian_bound[1] = -0.5;
  EXPECT_EQ(validity_warning(mesh),
            "the mesh is not valid: 1 of 2 elements are not proved, the worst is element 1 of block-1 at (0.5, 0)");
}

}  // namespace
}  // namespace quadrille::check
