#include <gtest/gtest.h>

#include "../chart_samples.hpp"
#include "../region_layout_samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using QuadMeshIo = RoundTrip;

TEST_F(QuadMeshIo, QuadMeshSurvivesTheRoundTrip) {
  expect_same_bytes(samples::quad_mesh());
  EXPECT_EQ(stage_format(read_input(path("first"))), "quad-mesh");
  QuadMesh mesh = samples::quad_mesh();
  mesh.is_valid = false;
  mesh.least_jacobian_bound = -0.25;
  expect_same_bytes(mesh);
  EXPECT_FALSE(read_stage<QuadMesh>(read_input(path("second"))).is_valid);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).least_jacobian_bound, -0.25);
}

TEST_F(QuadMeshIo, NodesInSpaceSurviveTheRoundTrip) {
  QuadMesh mesh = samples::quad_mesh();
  for (const Vec2 x : mesh.nodes) mesh.space_nodes.push_back(samples::on_sphere(x / 2));
  expect_same_bytes(mesh);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).space_nodes, mesh.space_nodes);
  EXPECT_EQ(stage_bytes(samples::quad_mesh()).find("space_nodes"), std::string::npos);
  EXPECT_EQ(stage_bytes(samples::quad_mesh()).find("chart"), std::string::npos);
}

TEST_F(QuadMeshIo, OpenCurvesAndStretchesAreOptional) {
  const std::string plain = stage_bytes(samples::quad_mesh());
  for (const char* name : {"open_curves", "elem_prescribed_stretch"})
    EXPECT_EQ(plain.find(name), std::string::npos) << name;
  const QuadMesh open = samples::open_regions_quads();
  expect_same_bytes(open);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).open_curves, open.open_curves);
  QuadMesh stretched = samples::quad_mesh();
  stretched.elem_prescribed_stretch = {{2, 0, 0.5}, {1, 0, 1}};
  expect_same_bytes(stretched);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).elem_prescribed_stretch[0].xx, 2);
}

}  // namespace

}  // namespace quadrille::io
