#include <gtest/gtest.h>

#include "../region_layout_samples.hpp"
#include "round_trip.hpp"

namespace quadrille::io {

namespace {

using BlockLayoutIo = RoundTrip;

TEST_F(BlockLayoutIo, BlockLayoutSurvivesTheRoundTrip) {
  expect_same_bytes(samples::block_layout());
  const BlockLayout layout = read_stage<BlockLayout>(read_input(path("second")));
  EXPECT_EQ(layout.block2arcs, samples::block_layout().block2arcs);
  EXPECT_EQ(layout.block_scaled_jacobian, samples::block_layout().block_scaled_jacobian);
  EXPECT_EQ(layout.block_boundary_distance, samples::block_layout().block_boundary_distance);
  EXPECT_EQ(layout.arcs[6].pieces[0].curve, 4);
  EXPECT_EQ(stage_format(read_input(path("first"))), "block-layout");
}

TEST_F(BlockLayoutIo, OpenCurvesAreKept) {
  const BlockLayout layout = samples::open_regions_layout();
  expect_same_bytes(layout);
  EXPECT_EQ(read_stage<BlockLayout>(read_input(path("second"))).open_curves, layout.open_curves);
}

}  // namespace

}  // namespace quadrille::io
