#include <gtest/gtest.h>

#include "../samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using HexMeshIo = RoundTrip;

TEST_F(HexMeshIo, HexMeshSurvivesTheRoundTrip) {
  HexMesh mesh = samples::hex_mesh();
  mesh.face_groups[1].is_interface = true;
  mesh.is_valid = false;
  expect_same_bytes(mesh);
  const HexMesh read = read_stage<HexMesh>(read_input(path("second")));
  EXPECT_EQ(read.face_groups[2].elems, mesh.face_groups[2].elems);
  EXPECT_TRUE(read.face_groups[1].is_interface);
  EXPECT_EQ(read.face_groups[4].motion.shift, mesh.face_groups[4].motion.shift);
  EXPECT_EQ(read.face_groups[4].motion.matrix, mesh.face_groups[4].motion.matrix);
}

}  // namespace

}  // namespace quadrille::io
