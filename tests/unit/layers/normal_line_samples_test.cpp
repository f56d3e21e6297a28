#include "layers/normal_line_samples.hpp"

#include <gtest/gtest.h>

#include "layers/arc_sizes.hpp"
#include "layers/layer_rules.hpp"
#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

using wall_samples::PlannedWalls;

std::vector<NormalLineSample> samples(const PlannedWalls& p) {
  return sample_normal_lines(p.measured, p.plan.walls, arc_sizes(p.input).prescribed);
}

TEST(NormalLineSamples, RunFromTheWallToTheFarSide) {
  const PlannedWalls p(hand_made::unit_square(), 0.2, {"side_1:first=0.1,layers=1"});
  const std::vector<NormalLineSample> lines = samples(p);
  ASSERT_EQ(lines.size(), static_cast<std::size_t>(layer_constants.lines_per_block));
  for (std::size_t k = 0; k < lines.size(); ++k) {
    const NormalLineSample& line = lines[k];
    EXPECT_NEAR(line.lengths.back(), 1, 1e-12);
    for (std::size_t i = 0; i < line.lengths.size(); ++i) EXPECT_NEAR(line.front_heights[i], line.lengths[i], 1e-12);
    EXPECT_NEAR(line.far_end.x, 0, 1e-12);
    EXPECT_NEAR(line.far_end.y, static_cast<double>(k) / static_cast<double>(lines.size() - 1), 1e-12);
    EXPECT_EQ(line.back, -1);
    EXPECT_EQ(line.size, 0.2);
  }
}

TEST(NormalLineSamples, CrossABlockBetweenTwoWallsOnce) {
  for (const auto& [a, b] : {std::pair{"side_0", "side_2"}, {"side_1", "side_3"}}) {
    const PlannedWalls p(hand_made::unit_square(), 0.2,
                         {std::string(a) + ":first=0.1,layers=1", std::string(b) + ":first=0.05,layers=1"});
    const std::vector<NormalLineSample> lines = samples(p);
    ASSERT_EQ(lines.size(), static_cast<std::size_t>(layer_constants.lines_per_block));
    EXPECT_EQ(lines[0].front, 0);
    EXPECT_EQ(lines[0].back, 1);
    for (std::size_t i = 0; i < lines[0].lengths.size(); ++i)
      EXPECT_NEAR(lines[0].back_heights[i], lines[0].front_heights[i], 1e-12);
  }
}

TEST(NormalLineSamples, WhatLiesBetweenLayers) {
  NormalLineSample line{0,  0, 1, 0.1, {0, 1, 2, 3}, {0, 0.5, 1, 1.5}, {0, 1, 2, 3},
                        {}, {}};  // the front wall is slanted
  const FreePart part = part_between_layers(line, {{0.25, 0.5}, {0.6}});
  EXPECT_NEAR(part.length, 3 - 1 - 0.6, 1e-15);
  EXPECT_NEAR(part.ends.before, 0.5, 1e-15);
  EXPECT_NEAR(part.ends.after, 0.6, 1e-15);
  EXPECT_EQ(part.layers, 3);
  EXPECT_EQ(part_between_layers(line, {{}, {}}).length, 3);
}

TEST(NormalLineSamples, NoClearanceWhereALineTurnsBackOrEnds) {
  const NormalLineSample turning{0, 0, -1, 0.1, {0, 1, 2, 3}, {0, 0.5, 0.4, 1.5}, {}, {}};
  EXPECT_GT(part_between_layers(turning, {{0.5}}).length, 0);
  EXPECT_LT(part_between_layers(turning, {{0.6}}).length, 0);
  const NormalLineSample low{0, 0, -1, 0.1, {0, 1}, {0, 0.5}, {}, {}};
  EXPECT_LT(part_between_layers(low, {{0.6}}).length, 0);
}

}  // namespace
}  // namespace quadrille::layers
