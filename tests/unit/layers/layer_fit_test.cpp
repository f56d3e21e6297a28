#include "layers/layer_fit.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "layers/end_spacing.hpp"
#include "layers/layer_rules.hpp"
#include "line_samples.hpp"
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

using namespace wall_samples;

const std::string fit = "a:first=0.1,law=uniform,layers=fit";

TEST(LayerFit, GrowthBeyondTheLayersIsAtLeastATenth) {
  WallSpec spec;
  for (const auto& [growth, beyond] : {std::pair{1.0, 1.1}, {1.1, 1.1}, {1.2, 1.2}, {2.0, 2.0}}) {
    spec.growth = growth;
    EXPECT_EQ(growth_beyond(spec), beyond);
  }
}

TEST(LayerFit, OnlyTheLinesOfAWallLimitIt) {
  const std::vector<NormalLineSample> lines{straight(0, 1, 0), straight(1, 0.5, 1)};
  EXPECT_EQ(fitting_layers(parse({fit, fit}), lines, {}), (std::vector<int>{9, 4}));
  EXPECT_EQ(fitting_layers(parse({fit, fit}), {lines[1], lines[0]}, {}), (std::vector<int>{9, 4}));
}

TEST(LayerFit, TheNarrowestLineOfAWallCounts) {
  EXPECT_EQ(fitting(fit, {straight(0, 1, 0), straight(1, 0.9, 0), straight(2, 0.95, 0)}), 8);
}

TEST(LayerFit, HeightsAreThoseAboveTheWallNotLengthsAlongTheLine) {
  // A line that leaves the wall at 30 degrees: half as high as long. Four layers of 0.1 end at 0.8 of it; above them
  // 0.2 are left, and the fifth would end at its end.
  NormalLineSample slanted = straight(0, 1, 0);
  for (double& height : slanted.front_heights) height /= 2;
  EXPECT_EQ(fitting(fit, {slanted}), 4);
}

TEST(LayerFit, NoMoreThanTheGreatestNumber) {
  EXPECT_EQ(fitting("a:first=1e-6,law=uniform,layers=fit", {straight(0, 1, 0, -1, 1e-6)}), layer_constants.max_layers);
}

TEST(LayerFit, AWallOppositeToItselfHasBothItsLayers) {
  // The lines of a slot begin and end on one wall.
  EXPECT_EQ(fitting(fit, {straight(0, 1, 0, 0)}), 4);
}

TEST(LayerFit, BothWallsOfALineAreNamedWithTheirOwnNumber) {
  const std::vector<WallSpec> specs =
      parse({"low:first=0.1,law=uniform,layers=7", "high:first=0.1,law=uniform,layers=4"});
  try {
    fitting_layers(specs, {straight(0, 1, 0, 1)}, {});
    FAIL() << "no exception";
  } catch (const ComputeError& error) {
    const std::string message = error.what();
    EXPECT_TRUE(message.starts_with("--wall low: ")) << message;
    EXPECT_NE(message.find("at most 6 fit, with a thickness of 0.6"), std::string::npos) << message;
  }
  EXPECT_EQ(fitting_layers(parse({"low:first=0.1,law=uniform,layers=6", "high:first=0.1,law=uniform,layers=3"}),
                           {straight(0, 1, 0, 1)}, {}),
            (std::vector<int>{6, 3}));
}

}  // namespace
}  // namespace quadrille::layers
