#include "sweep/sweep.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "sweep_samples.hpp"

namespace quadrille::sweep {
namespace {

TEST(Sweep, AgainstTheNormalQuadsAreMirrored) {
  const QuadMesh mesh = quads(3);
  const HexMesh hexes = swept(mesh, straight({0, 0, -1}), {0, 1});
  expect_proved(hexes);
  EXPECT_EQ(hexes.elem_nodes[1], mesh.elem_nodes[4]);
  EXPECT_EQ(hexes.face_groups[0].faces, (std::vector<int>{3, 3}));
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

}  // namespace
}  // namespace quadrille::sweep
