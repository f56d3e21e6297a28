#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using CadFaceIo = RoundTrip;

TEST_F(CadFaceIo, RegionsSurviveTheRoundTrip) {
  expect_same_bytes(samples::two_regions_mesh());
  const TriMesh mesh = read_stage<TriMesh>(read_input(path("second"))), expected = samples::two_regions_mesh();
  EXPECT_EQ(mesh.region_elems, expected.region_elems);
  expect_same_regions(mesh.face, expected.face);
  expect_same_bytes(samples::two_regions_points());
  expect_same_regions(read_stage<CriticalPoints>(read_input(path("second"))).face, expected.face);
  expect_same_bytes(samples::two_regions_field());
  expect_same_regions(read_stage<Field>(read_input(path("second"))).mesh.face, expected.face);
}

TEST_F(CadFaceIo, RegionsOfLayoutsAndMeshesSurviveTheRoundTrip) {
  expect_same_bytes(samples::two_regions_graph());
  expect_same_regions(read_stage<SeparatrixGraph>(read_input(path("second"))).face, samples::two_regions_face());
  expect_same_bytes(samples::two_regions_layout());
  EXPECT_EQ(read_stage<BlockLayout>(read_input(path("second"))).block_region, (std::vector<int>{0, 1}));
  expect_same_bytes(samples::two_regions_quads());
  const QuadMesh mesh = read_stage<QuadMesh>(read_input(path("second")));
  EXPECT_EQ(mesh.block_region, (std::vector<int>{0, 1}));
  ASSERT_EQ(mesh.interface_edges.size(), 2u);
  EXPECT_EQ(mesh.interface_edges[1].curve, 7);
}

TEST_F(CadFaceIo, OneRegionHasNoArraysOfRegions) {
  const auto bytes = [&](const auto& stage) {
    write_stage(path("file"), stage);
    return bytes_of("file");
  };
  for (const char* name : {"region_elems", "region_loops", "region_names", "partners", "periodic_pairs"}) {
    EXPECT_EQ(bytes(samples::tri_mesh()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_mesh()).find(name), std::string::npos) << name;
  }
  for (const char* name : {"block_region", "region_names"}) {
    EXPECT_EQ(bytes(samples::block_layout()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_layout()).find(name), std::string::npos) << name;
  }
  for (const char* name : {"block_region", "interface_edges"}) {
    EXPECT_EQ(bytes(samples::quad_mesh()).find(name), std::string::npos) << name;
    EXPECT_NE(bytes(samples::two_regions_quads()).find(name), std::string::npos) << name;
  }
  const std::string slit = bytes(samples::slit_mesh());
  EXPECT_NE(slit.find("partners"), std::string::npos);
  EXPECT_EQ(slit.find("region_"), std::string::npos);
}

TEST_F(CadFaceIo, NamesThatNobodyGaveAreRecorded) {
  BlockLayout layout = samples::block_layout();
  layout.unnamed_blocks = {1};
  layout.face.unnamed_curves = {0, 2};
  expect_same_bytes(layout);
  const BlockLayout read = read_stage<BlockLayout>(read_input(path("second")));
  EXPECT_EQ(read.unnamed_blocks, layout.unnamed_blocks);
  EXPECT_EQ(read.face.unnamed_curves, layout.face.unnamed_curves);
  QuadMesh mesh = samples::quad_mesh();
  mesh.unnamed_blocks = {0};
  expect_same_bytes(mesh);
  EXPECT_EQ(read_stage<QuadMesh>(read_input(path("second"))).unnamed_blocks, mesh.unnamed_blocks);
}

}  // namespace

}  // namespace quadrille::io
