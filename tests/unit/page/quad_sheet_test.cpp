#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "../export/two_quads.hpp"
#include "sheet_samples.hpp"

namespace quadrille::page {
namespace {

TEST(QuadSheet, EdgesAreThereOnceWithASignForTheirDirection) {
  const Sheet sheet = stage_sheet(samples::quad_mesh(), frame);
  EXPECT_EQ(sheet.caption, "2 quads of order 1 in 2 blocks");
  const std::string layer = layer_of(sheet, "mesh");
  expect_contains(layer, member("elements", {1, 2, 3, 4, 5, 6, 7, -2}));
  expect_contains(layer, R"("blockNames":["block-0","block-1"])");
}

/// Both rings of the second quad run below, between the ends of those of the first above.
TEST(QuadSheet, EdgesBetweenTheSameVerticesAreTold) {
  const std::string layer = layer_of(stage_sheet(exports::ring_of_two_quads(), frame), "mesh");
  expect_contains(layer, member("elements", {1, 2, 3, 4, -3, 5, -1, 6}));
}

/// A parallelogram at 45 degrees, half of a right angle off.
TEST(QuadSheet, SkewnessIsTheGreatestDeviationFromARightAngle) {
  QuadMesh mesh = samples::quad_mesh();
  for (Vec2& x : mesh.nodes) x.x += x.y;
  const std::string layer = layer_of(stage_sheet(mesh, frame), "mesh");
  const std::size_t at = layer.find(R"("title":"skewness")");
  ASSERT_NE(at, std::string::npos);
  expect_contains(layer.substr(at, 300), packed_floats({0.5, 0.5}));
}

TEST(QuadSheet, PrescribedLengthsAreComparedIfTheFileHasThem) {
  QuadMesh mesh = samples::quad_mesh();
  EXPECT_EQ(count(layer_of(stage_sheet(mesh, frame), "mesh"), "size against prescribed"), 1);
  mesh.elem_prescribed_length.clear();
  EXPECT_EQ(count(layer_of(stage_sheet(mesh, frame), "mesh"), "size against prescribed"), 0);
}

TEST(QuadSheet, MeshesInSpaceHaveAPaneBesideTheChart) {
  QuadMesh mesh = samples::quad_mesh();
  EXPECT_TRUE(stage_sheet(mesh, frame).space.empty());
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x / 2));
  const Sheet sheet = stage_sheet(mesh, frame);
  EXPECT_FALSE(sheet.space.empty() || sheet.is_only_in_space);
}

}  // namespace
}  // namespace quadrille::page
