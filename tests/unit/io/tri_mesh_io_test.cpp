#include <gtest/gtest.h>

#include "../samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using TriMeshIo = RoundTrip;

TEST_F(TriMeshIo, TriMeshSurvivesTheRoundTrip) {
  expect_same_bytes(samples::tri_mesh());
  const TriMesh mesh = read_stage<TriMesh>(read_input(path("second"))), expected = samples::tri_mesh();
  EXPECT_EQ(mesh.vertices, expected.vertices);
  EXPECT_EQ(mesh.elem2vertices, expected.elem2vertices);
  EXPECT_EQ(mesh.curved_nodes, expected.curved_nodes);
  EXPECT_EQ(mesh.face.curve_names, expected.face.curve_names);
  EXPECT_EQ(mesh.face.joints[1].interior_angle, expected.face.joints[1].interior_angle);
  EXPECT_TRUE(mesh.face.joints[3].is_corner);
  EXPECT_EQ(mesh.provenance[0].options, expected.provenance[0].options);
  EXPECT_EQ(stage_format(read_input(path("first"))), "tri-mesh");
}

TEST_F(TriMeshIo, RepairsAreKept) {
  expect_same_bytes(samples::tri_mesh());
  const TriMesh mesh = read_stage<TriMesh>(read_input(path("second")));
  ASSERT_EQ(mesh.repairs.size(), 1u);
  EXPECT_EQ(mesh.repairs[0].kind, RepairKind::joint);
  EXPECT_EQ(mesh.repairs[0].distance, 1e-6);
}

}  // namespace

}  // namespace quadrille::io
