#include <gtest/gtest.h>

#include <limits>

#include "../region_samples.hpp"
#include "rules_of.hpp"

namespace quadrille::check {
namespace {

template <typename Damage>
Rules broken(const Damage& damage) {
  return broken_rules(samples::tri_mesh(), damage);
}

TEST(TriMeshCheck, TheSampleIsValid) {
  EXPECT_EQ(broken([](TriMesh&) {}), Rules{});
}

TEST(TriMeshCheck, FaceRulesComeFirst) {
  EXPECT_EQ(broken([](TriMesh& m) { m.face.loop_offsets = {0}; }), Rules{"FAC-R02"});
}
TEST(TriMeshCheck, TriR01ArraysAgree) {
  EXPECT_EQ(broken([](TriMesh& m) { m.order = 0; }), Rules{"TRI-R01"});
  EXPECT_EQ(broken([](TriMesh& m) { m.order = 3; }), Rules{"TRI-R01"});
  EXPECT_EQ(broken([](TriMesh& m) { m.elem_layer.pop_back(); }), Rules{"TRI-R01"});
}
TEST(TriMeshCheck, TriR02VerticesExist) {
  EXPECT_EQ(broken([](TriMesh& m) { m.elem2vertices[2][1] = 5; }), Rules{"TRI-R02"});
  EXPECT_EQ(broken([](TriMesh& m) { m.elem2vertices[2][1] = -1; }), Rules{"TRI-R02"});
  EXPECT_EQ(broken([](TriMesh& m) { m.elem2vertices[2][1] = 2; }), Rules{"TRI-R02"});
}
TEST(TriMeshCheck, TriR03CurvedElemsAscend) {
  EXPECT_EQ(broken([](TriMesh& m) { m.curved_elems = {4}; }), Rules{"TRI-R03"});
  EXPECT_EQ(broken([](TriMesh& m) {
              m.curved_elems = {1, 0};
              m.curved_nodes.resize(12);
            }),
            Rules{"TRI-R03"});
}
TEST(TriMeshCheck, TriR04BoundaryEdgesExist) {
  EXPECT_EQ(broken([](TriMesh& m) { m.boundary_edges[1].edge = 3; }), Rules{"TRI-R04"});
  EXPECT_EQ(broken([](TriMesh& m) { m.boundary_edges[1].elem = -1; }), Rules{"TRI-R04"});
  EXPECT_EQ(broken([](TriMesh& m) { m.boundary_edges[1].curve = 4; }), Rules{"TRI-R04"});
}
TEST(TriMeshCheck, TriR05NumbersAreFinite) {
  EXPECT_EQ(broken([](TriMesh& m) { m.vertices[4].x = std::numeric_limits<double>::quiet_NaN(); }), Rules{"TRI-R05"});
}
TEST(TriMeshCheck, TriR06BoundaryEdgesCoverTheCurves) {
  EXPECT_EQ(broken([](TriMesh& m) { std::swap(m.boundary_edges[0], m.boundary_edges[1]); }), Rules{"TRI-R06"});
  EXPECT_EQ(broken([](TriMesh& m) { m.boundary_edges[3].t1 = 0.5; }), (Rules{"TRI-R06", "TRI-R07"}));
}
TEST(TriMeshCheck, TriR07BoundaryVerticesLieOnTheirCurves) {
  EXPECT_EQ(broken([](TriMesh& m) { m.vertices[2] = {1.001, 1}; }), Rules{"TRI-R07"});
}
TEST(TriMeshCheck, TriR08CurvedCornersAreVertices) {
  EXPECT_EQ(broken([](TriMesh& m) { m.curved_nodes[2] = {0.5, 0.4999}; }), Rules{"TRI-R08"});
}
TEST(TriMeshCheck, TriR09StraightElementsAreCounterClockwise) {
  EXPECT_TRUE(broken([](TriMesh& m) { std::swap(m.elem2vertices[2][0], m.elem2vertices[2][1]); }).contains("TRI-R09"));
  EXPECT_EQ(broken([](TriMesh& m) {
              m.curved_elems.clear();
              m.curved_nodes.clear();
              m.vertices[4] = {1.5, 0.5};
            }),
            Rules{"TRI-R09"});
}
TEST(TriMeshCheck, TriR10EdgesAreShared) {
  EXPECT_EQ(broken([](TriMesh& m) { m.boundary_edges[2].edge = 1; }), (Rules{"TRI-R07", "TRI-R10"}));
}
TEST(TriMeshCheck, TriR11EulerCount) {
  EXPECT_EQ(broken([](TriMesh& m) { m.vertices.push_back({0.1, 0.1}); }), Rules{"TRI-R11"});
}
TEST(TriMeshCheck, TriR12NeighboursShareShapes) {
  EXPECT_EQ(broken([](TriMesh& m) { m.curved_nodes[4].y += 1e-6; }), Rules{"TRI-R12"});
}
TEST(TriMeshCheck, TriR13JacobiansArePositive) {
  // The middle of the lower side pushed through the opposite vertex.
  EXPECT_EQ(broken([](TriMesh& m) { m.curved_nodes[3] = {0.5, 0.6}; }), Rules{"TRI-R13"});
}
TEST(TriMeshCheck, QuickDepthLeavesTheProofsOut) {
  TriMesh mesh = samples::tri_mesh();
  mesh.curved_nodes[3] = {0.5, 0.6};
  EXPECT_TRUE(check_stage(mesh, CheckDepth::quick).empty());
}

template <typename Damage>
Rules broken_regions(const Damage& damage) {
  return broken_rules(samples::two_regions_mesh(), damage);
}

TEST(TriMeshCheck, RegionsAndSlitsAreValid) {
  EXPECT_EQ(broken_regions([](TriMesh&) {}), Rules{});
  EXPECT_EQ(rules_of(check_stage(samples::slit_mesh(), CheckDepth::full)), Rules{});
}
TEST(TriMeshCheck, TriR01ElementsOfEachRegion) {
  for (const std::vector<int>& wrong : std::vector<std::vector<int>>{{}, {0, 8}, {0, 4, 7}, {0, 8, 8}, {1, 4, 8}})
    EXPECT_EQ(broken_regions([&](TriMesh& m) { m.region_elems = wrong; }), Rules{"TRI-R01"});
  EXPECT_EQ(broken([](TriMesh& m) { m.region_elems = {0, 2, 4}; }), Rules{"TRI-R01"}) << "one region";
}
TEST(TriMeshCheck, TriR11EachRegionCounts) {
  EXPECT_TRUE(broken_regions([](TriMesh& m) {
                m.region_elems = {0, 3, 8};
              }).contains("TRI-R11"))
      << "the sum over the regions is right";
}
TEST(TriMeshCheck, TriR14RegionsHaveElementsOfTheirOwn) {
  EXPECT_EQ(broken_regions([](TriMesh& m) { m.region_elems = {0, 3, 8}; }), (Rules{"TRI-R11", "TRI-R14"}));
  EXPECT_TRUE(broken_regions([](TriMesh& m) {
                // The right square's corner becomes that of the left one.
                for (auto& triangle : m.elem2vertices)
                  for (int& v : triangle) v = v == 5 ? 1 : v;
              }).contains("TRI-R14"));
  EXPECT_EQ(broken_regions([](TriMesh& m) {
              for (BoundaryEdge& edge : m.boundary_edges) edge.elem = 7 - edge.elem;
            }).contains("TRI-R14"),
            true);
}
TEST(TriMeshCheck, TriR10BothSidesOfASlitHaveVerticesOfTheirOwn) {
  TriMesh mesh = samples::slit_mesh();
  for (auto& triangle : mesh.elem2vertices)
    for (int& v : triangle) v = v == 7 ? 6 : v;
  const Rules rules = rules_of(check_stage(mesh, CheckDepth::full));
  EXPECT_EQ(rules, (Rules{"TRI-R10", "TRI-R11"}));
}

}  // namespace
}  // namespace quadrille::check
