#include "sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../region_layout_samples.hpp"
#include "../samples.hpp"
#include "base/angle.hpp"
#include "base/error.hpp"
#include "spectral/hex_map.hpp"
#include "spectral/quadrature.hpp"
#include "sweep/layer_ends.hpp"

namespace quadrille::sweep {
namespace {

/// The unit square as two quads of the order, whose common side is bent.
QuadMesh quads(int order) {
  QuadMesh mesh = samples::quad_mesh();
  mesh.order = order;
  mesh.nodes.clear(), mesh.elem_nodes.clear();
  const std::vector<double>& xi = spectral::gll_points(order);
  const int n = order + 1, row = 2 * order + 1;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < row; ++i) {
      const double y = (1 + xi[j]) / 2, s = i <= order ? (1 + xi[i]) / 4 : (3 + xi[i - order]) / 4;
      mesh.nodes.push_back({s + (order > 1 ? 0.3 * s * (1 - s) * y * (1 - y) : 0), y});
    }
  for (int e = 0; e < 2; ++e)
    for (int j = 0; j < n; ++j)
      for (int i = 0; i < n; ++i) mesh.elem_nodes.push_back(j * row + e * order + i);
  mesh.elem_jacobian_bound = {0.1, 0.1};
  mesh.elem_scaled_jacobian = {0.9, 0.9};
  return mesh;
}

HexMesh swept(const QuadMesh& mesh, const SweepShape& shape, std::vector<double> ends, SweepPlan plan = {}) {
  plan.ends = std::move(ends);
  std::vector<std::string> lost;
  return sweep(mesh, SweepMotion(shape), plan, 1, nullptr, lost);
}

SweepShape straight(Vec3 along) {
  SweepShape shape;
  shape.along = along, shape.normal = {0, 0, 1}, shape.centre = {0.5, 0.5, 0};
  return shape;
}

SweepShape revolved(double angle, Vec3 point, Vec3 direction) {
  SweepShape shape = straight({});
  shape.axis = Axis{point, direction}, shape.angle = angle;
  return shape;
}

void expect_proved(const HexMesh& mesh) {
  EXPECT_TRUE(mesh.is_valid);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    std::vector<Vec3> nodes;
    for (int k = 0; k < mesh.nodes_per_elem(); ++k)
      nodes.push_back(mesh.nodes[mesh.elem_nodes[e * mesh.nodes_per_elem() + k]]);
    EXPECT_GT(spectral::hex_bounds(mesh.order, nodes.data()).jacobian, 0) << e;
    EXPECT_GT(mesh.elem_jacobian_bound[e], 0) << e;
  }
}

TEST(Sweep, AStraightSweepCarriesTheProofOfTheQuads) {
  for (const int order : {1, 2, 5}) {
    const HexMesh mesh = swept(quads(order), straight({0, 0, 2}), {0, 0.25, 1});
    ASSERT_EQ(mesh.num_elems(), 4);
    EXPECT_EQ(mesh.num_layers(), 2);
    EXPECT_NEAR(mesh.elem_jacobian_bound[0], 0.1 * 0.25, 1e-9);
    EXPECT_NEAR(mesh.elem_jacobian_bound[3], 0.1 * 0.75, 1e-9);
    EXPECT_EQ(mesh.elem_scaled_jacobian[2], 0.9);
    expect_proved(mesh);
  }
}

TEST(Sweep, AnObliqueSweepIsSkewed) {
  const HexMesh mesh = swept(quads(2), straight({1, 0, 1}), {0, 1});
  EXPECT_NEAR(mesh.elem_jacobian_bound[0], 0.1 / 2, 1e-9);
  EXPECT_NEAR(mesh.elem_scaled_jacobian[0], 0.9 * std::sqrt(0.5), 1e-12);
  expect_proved(mesh);
}

TEST(Sweep, AgainstTheNormalQuadsAreMirrored) {
  const QuadMesh mesh = quads(3);
  const HexMesh hexes = swept(mesh, straight({0, 0, -1}), {0, 1});
  expect_proved(hexes);
  EXPECT_EQ(hexes.elem_nodes[1], mesh.elem_nodes[4]);
  EXPECT_EQ(hexes.face_groups[0].faces, (std::vector<int>{3, 3}));
}

TEST(Sweep, SidesHaveTheNamesOfCurvesAndEndsTheirOwn) {
  const HexMesh mesh = swept(quads(2), straight({0, 0, 1}), {0, 0.5, 1});
  ASSERT_EQ(mesh.face_groups.size(), 6u);
  const CadFace face = samples::face();
  EXPECT_EQ(mesh.face_groups[1].name, face.curve_names[1]);
  EXPECT_EQ(mesh.face_groups[1].elems, (std::vector<int>{1, 3}));
  EXPECT_EQ(mesh.face_groups[1].faces, (std::vector<int>{1, 1}));
  EXPECT_EQ(mesh.face_groups[4].name, "bottom");
  EXPECT_EQ(mesh.face_groups[5].name, "top");
  EXPECT_EQ(mesh.face_groups[5].elems, (std::vector<int>{2, 3}));
  SweepPlan plan;
  plan.top_name = face.curve_names[1];
  EXPECT_THROW(swept(quads(2), straight({0, 0, 1}), {0, 1}, plan), UsageError);
}

TEST(Sweep, EndsCanBePeriodic) {
  SweepPlan plan;
  plan.has_periodic_ends = true;
  SweepShape shape = straight({0, 0, 1});
  shape.twist = 1;
  const HexMesh mesh = swept(quads(3), shape, {0, 0.5, 1}, plan);
  EXPECT_EQ(mesh.face_groups[4].periodic_with, 5);
  expect_proved(mesh);
  shape.taper = 0.5;
  EXPECT_THROW(swept(quads(3), shape, {0, 1}, plan), UsageError);
}

TEST(Sweep, PeriodicSidesStayPeriodicWhereOneMotionDoes) {
  QuadMesh mesh = quads(2);
  mesh.face.periodic_pairs = {{{1, 3}, 0, {-1, 0}}};
  EXPECT_EQ(swept(mesh, straight({0.5, 0, 1}), {0, 1}).face_groups[1].periodic_with, 3);
  SweepShape twisted = straight({0, 0, 1});
  twisted.twist = 1;
  std::vector<std::string> lost;
  SweepPlan plan;
  plan.ends = {0, 1};
  EXPECT_EQ(sweep(mesh, SweepMotion(twisted), plan, 1, nullptr, lost).face_groups[1].periodic_with, -1);
  EXPECT_EQ(lost, std::vector<std::string>{mesh.face.curve_names[1]});
}

TEST(Sweep, EqualLayersOfARevolutionAreProvedOnce) {
  const HexMesh mesh = swept(quads(4), revolved(pi / 2, {-1, 0, 0}, {0, 1, 0}), {0, 0.25, 0.5, 0.75, 1});
  expect_proved(mesh);
  for (int e = 2; e < 8; ++e) {
    EXPECT_NEAR(mesh.elem_jacobian_bound[e], mesh.elem_jacobian_bound[e % 2], 1e-9);
    EXPECT_EQ(mesh.elem_scaled_jacobian[e], mesh.elem_scaled_jacobian[e % 2]);
  }
  // The face turns to x = -1.
  const Vec3 last = mesh.nodes.back();
  EXPECT_NEAR(last.x, -1, 1e-14);
  EXPECT_NEAR(last.y, 1, 1e-14);
  EXPECT_NEAR(std::abs(last.z), 2, 1e-14);
}

TEST(Sweep, AFullTurnCloses) {
  const HexMesh mesh = swept(quads(2), revolved(2 * pi, {-1, 0, 0}, {0, 1, 0}), {0, 0.25, 0.5, 0.75, 1});
  EXPECT_EQ(mesh.nodes.size(), 8 * quads(2).nodes.size());
  EXPECT_EQ(mesh.face_groups.size(), 4u);
  expect_proved(mesh);
}

TEST(Sweep, TwistAndTaperAreProved) {
  SweepShape shape = straight({0, 0, 2});
  shape.twist = pi / 2, shape.taper = 0.5;
  const HexMesh mesh = swept(quads(3), shape, {0, 0.25, 0.5, 0.75, 1});
  expect_proved(mesh);
  const std::size_t top = mesh.nodes.size() - quads(3).nodes.size();
  EXPECT_NEAR(mesh.nodes[top].x, 0.75, 1e-14);
  EXPECT_NEAR(mesh.nodes[top].y, 0.25, 1e-14);
}

TEST(Sweep, AnElementThatCannotBeProvedIsNamed) {
  SweepShape shape = straight({0, 0, 0.1});
  shape.twist = 2 * pi;
  const HexMesh mesh = swept(quads(2), shape, {0, 1});
  EXPECT_FALSE(mesh.is_valid);
  EXPECT_THROW(require_valid_elements(mesh), ComputeError);
}

TEST(Sweep, WhatDoesNotLeadOutOfTheFaceIsRefused) {
  EXPECT_THROW(swept(quads(2), straight({1, 2, 0}), {0, 1}), UsageError);
  EXPECT_THROW(swept(quads(2), revolved(1, {-1, 0, 0}, {0, 0, 1}), {0, 1}), UsageError);
  EXPECT_THROW(swept(quads(2), revolved(1, {0.5, 0, 0}, {0, 1, 0}), {0, 1}), UsageError) << "the axis crosses the face";
  EXPECT_NO_THROW(swept(quads(2), straight({1, 2, 1e-3}), {0, 1}));
  SweepShape curved = straight({});
  curved.curve = {{0, 0, 0}, {1, 0, 0}, {2, 1, 0}};
  EXPECT_THROW(swept(quads(2), curved, {0, 1}), UsageError);
}

TEST(Sweep, MemoryGrowsWithLayersAndWhatExceedsItIsRefused) {
  const QuadMesh mesh = quads(4);  // 45 nodes, 50 entries
  EXPECT_NEAR(memory_of(mesh, 1000), 6 * (45 * 24 * 4001.0 + 4 * 250 * 1000.0), 1);
  EXPECT_THROW(swept(mesh, straight({0, 0, 1}), std::vector<double>(1 << 24)), ComputeError);
}

TEST(Sweep, TheErrorOfTheMotionIsTheSagOfItsArcs) {
  const SweepMotion quarter(revolved(pi / 2, {-1, 0, 0}, {0, 1, 0}));
  EXPECT_NEAR(motion_error(quads(1), quarter, {0, 1}), 2 * (1 - std::cos(pi / 4)), 1e-12);
  EXPECT_NEAR(motion_error(quads(1), quarter, {0, 0.5, 1}), 2 * (1 - std::cos(pi / 8)), 1e-12);
  EXPECT_LT(motion_error(quads(5), quarter, {0, 0.5, 1}), 1e-6);
  EXPECT_LT(motion_error(quads(2), SweepMotion(straight({1, 2, 3})), {0, 1}), 1e-14);
}

TEST(Sweep, InterfacesAreNamedFromBothSides) {
  SweepPlan plan;  // sides of the face are called bottom and top
  plan.bottom_name = "low", plan.top_name = "high";
  const HexMesh mesh = swept(samples::two_regions_quads(), straight({0, 0, 1}), {0, 1}, plan);
  EXPECT_EQ(mesh.region_names.size(), 2u);
  int interfaces = 0;
  for (const HexFaceGroup& group : mesh.face_groups) {
    if (!group.is_interface) continue;
    ++interfaces;
    EXPECT_EQ(group.elems.size() % 2, 0u);
  }
  EXPECT_EQ(interfaces, 1);
}

TEST(Sweep, ACurveCarriesTheFaceWithoutTurningItAboutTheTangent) {
  SweepShape shape = straight({});
  for (int k = 0; k <= 40; ++k) {
    const double t = pi / 2 * k / 40;
    shape.curve.push_back({4 - 4 * std::cos(t), 0.5, 4 * std::sin(t)});
  }
  const HexMesh mesh = swept(quads(3), shape, {0, 0.25, 0.5, 0.75, 1});
  expect_proved(mesh);
  // As a revolution about x = 4, z = 0.
  const std::size_t count = quads(3).nodes.size(), top = mesh.nodes.size() - count;
  for (std::size_t q = 0; q < count; ++q) {
    const Vec3 from = mesh.nodes[q], to = mesh.nodes[top + q];
    EXPECT_NEAR(to.x, 4, 5e-5);
    EXPECT_NEAR(to.y, from.y, 5e-5);
    EXPECT_NEAR(to.z, 4 - from.x, 5e-5);
  }
}

TEST(Sweep, HeightsMoveTheBottomAlone) {
  QuadMesh mesh = quads(3);
  SweepPlan plan;
  for (const Vec2 x : mesh.nodes) plan.bottom_heights.push_back(0.2 * std::sin(3 * x.x) * x.y);
  const HexMesh hexes = swept(mesh, straight({0, 0, 1}), {0, 0.5, 1}, plan);
  expect_proved(hexes);
  for (std::size_t q = 0; q < mesh.nodes.size(); ++q) {
    EXPECT_EQ(hexes.nodes[q].z, plan.bottom_heights[q]);
    EXPECT_EQ(hexes.nodes[hexes.nodes.size() - mesh.nodes.size() + q].z, 1);
  }
}

TEST(LayerEnds, AreGeometricOrAsHighAsUsual) {
  EXPECT_EQ(layer_ends({4, 1, {}, {}}, 2, 0.1), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(layer_ends({0, 1, {}, {}}, 2, 0.5).size(), 5u);
  const std::vector<double> grown = layer_ends({3, 2, {}, {}}, 7, 1);
  EXPECT_NEAR(grown[1], 1.0 / 7, 1e-15);
  EXPECT_NEAR(grown[2], 3.0 / 7, 1e-15);
}

TEST(LayerEnds, WallLayersKeepTheirHeights) {
  LayerPlan plan;
  plan.bottom = layers::parse_layer_spec("--bottom-layers", "first=0.01,growth=1.5,layers=3");
  plan.top = layers::parse_layer_spec("--top-layers", "first=0.02,layers=2");
  const std::vector<double> ends = layer_ends(plan, 2, 0.2);
  EXPECT_NEAR(ends[1], 0.01 / 2, 1e-15);
  EXPECT_NEAR(ends[3], 0.0475 / 2, 1e-15);
  EXPECT_NEAR(1 - ends[ends.size() - 2], 0.02 / 2, 1e-15);
  for (std::size_t k = 2; k < ends.size(); ++k) {
    const double ratio = (ends[k] - ends[k - 1]) / (ends[k - 1] - ends[k - 2]);
    EXPECT_LE(std::max(ratio, 1 / ratio), 1.5 * (1 + 1e-5)) << k;
    EXPECT_LE(ends[k] - ends[k - 1], 0.1 * (1 + 1e-5));
  }
  EXPECT_THROW(layer_ends(plan, 0.05, 0.2), UsageError);
}

}  // namespace
}  // namespace quadrille::sweep
