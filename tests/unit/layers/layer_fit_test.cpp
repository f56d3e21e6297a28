// Rules 10 to 13 have their tests in layer_rules_test.
#include "layers/layer_fit.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "layers/layer_rules.hpp"
#include "line_samples.hpp"

namespace quadrille::layers {
namespace {

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
