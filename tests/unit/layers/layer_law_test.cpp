#include "layers/layer_law.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/error.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

WallSpec spec_of(LayerLaw law, double first, double growth) {
  WallSpec spec;
  spec.law = law, spec.first = first, spec.growth = growth;
  return spec;
}

TEST(LayerLaw, GeometricLayersGrowByTheirFactor) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::geometric, 0.5, 2), 4);
  EXPECT_EQ(heights, (std::vector<double>{0.5, 1.5, 3.5, 7.5}));
}

TEST(LayerLaw, UniformLayersAreEqual) {
  EXPECT_EQ(layer_heights(spec_of(LayerLaw::uniform, 0.25, 1.5), 3), (std::vector<double>{0.25, 0.5, 0.75}));
}

TEST(LayerLaw, TanhKeepsFirstHeightAndThicknessAndGrowsEverLess) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::tanh, 1e-3, 1.2), 20);
  EXPECT_EQ(heights.front(), 1e-3);
  EXPECT_NEAR(heights.back(), 1e-3 * (std::pow(1.2, 20) - 1) / 0.2, 1e-12);
  double last = 1e9;
  for (std::size_t k = 2; k < heights.size(); ++k) {
    const double below = heights[k - 1] - heights[k - 2], above = heights[k] - heights[k - 1];
    EXPECT_GT(above, below);
    EXPECT_LT(above / below, last);
    last = above / below;
  }
}

TEST(LayerLaw, TanhWithoutGrowthIsUniform) {
  EXPECT_EQ(layer_heights(spec_of(LayerLaw::tanh, 1, 1), 3), (std::vector<double>{1, 2, 3}));
}

TEST(LayerLaw, GllHeightsAreHalfASpectralGrid) {
  const std::vector<double> heights = layer_heights(spec_of(LayerLaw::gll, 2e-3, 1.2), 5);
  const std::vector<double>& points = spectral::gll_points(10);
  EXPECT_DOUBLE_EQ(heights.front(), 2e-3);
  for (int k = 1; k <= 5; ++k) EXPECT_NEAR(heights[k - 1] / heights.back(), 1 + points[k], 1e-12);
}

TEST(LayerLaw, ThicknessAsksForTheLeastNumberThatReachesIt) {
  WallSpec spec = spec_of(LayerLaw::geometric, 1, 2);
  for (const auto& [thickness, layers] : {std::pair{0.1, 1}, {1.0, 1}, {1.01, 2}, {3.0, 2}, {3.1, 3}}) {
    spec.thickness = thickness;
    EXPECT_EQ(requested_layers(spec), layers) << thickness;
  }
  spec.growth = 1, spec.thickness = 1e9;
  EXPECT_THROW(requested_layers(spec), UsageError);
}

TEST(LayerLaw, CompressedLayersAndOneMoreFillTheRoom) {
  const std::vector<double> heights{1, 3, 7};
  EXPECT_EQ(next_layer(heights), 8);
  EXPECT_EQ(compressed_heights(heights, 15), heights);
  const std::vector<double> compressed = compressed_heights(heights, 10);
  EXPECT_NEAR(compressed[0], 1, 1e-12);
  const double growth = compressed[1] - 1;
  EXPECT_NEAR(compressed[2] - compressed[1], growth * growth, 1e-9);
  EXPECT_NEAR(compressed[2] + growth * growth * growth, 10, 1e-9);
  const std::vector<double> equal = compressed_heights(heights, 2);
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(equal[k], 0.5 * (k + 1), 1e-12);
}

TEST(LayerLaw, MoreIntervalsAboveLeaveLessRoomForCompressedLayers) {
  const std::vector<double> heights{1, 3, 7};
  EXPECT_EQ(compressed_heights(heights, 15, 4), heights) << "four intervals of 2 above";
  EXPECT_LT(compressed_heights(heights, 10, 4).back(), compressed_heights(heights, 10).back());
  EXPECT_NEAR(compressed_heights(heights, 10, 4).front(), 1, 1e-12);
  for (const double room : {7, 5})
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(compressed_heights(heights, room, 4)[k], k + 1, 1e-9) << room;
}

}  // namespace
}  // namespace quadrille::layers
