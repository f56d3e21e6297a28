#include "sweep/layer_ends.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::sweep {
namespace {

TEST(LayerEnds, AreGeometricOrAsHighAsUsual) {
  EXPECT_EQ(layer_ends({4, 1, {}, {}}, 2, 0.1), (std::vector<double>{0, 0.25, 0.5, 0.75, 1}));
  EXPECT_EQ(layer_ends({0, 1, {}, {}}, 2, 0.5).size(), 5u);
  const std::vector<double> grown = layer_ends({3, 2, {}, {}}, 7, 1);
  EXPECT_NEAR(grown[1], 1.0 / 7, 1e-15);
  EXPECT_NEAR(grown[2], 3.0 / 7, 1e-15);
}

TEST(LayerEnds, WallLayersKeepTheirHeights) {
  LayerPlan plan;
  plan.bottom = layers::parse_layer_spec("--bottom-layers", "first=0.01,growth=1.5,layers=3");
  plan.top = layers::parse_layer_spec("--top-layers", "first=0.02,layers=2");
  const std::vector<double> ends = layer_ends(plan, 2, 0.2);
  EXPECT_NEAR(ends[1], 0.01 / 2, 1e-15);
  EXPECT_NEAR(ends[3], 0.0475 / 2, 1e-15);
  EXPECT_NEAR(1 - ends[ends.size() - 2], 0.02 / 2, 1e-15);
  for (std::size_t k = 2; k < ends.size(); ++k) {
    const double ratio = (ends[k] - ends[k - 1]) / (ends[k - 1] - ends[k - 2]);
    EXPECT_LE(std::max(ratio, 1 / ratio), 1.5 * (1 + 1e-5)) << k;
    EXPECT_LE(ends[k] - ends[k - 1], 0.1 * (1 + 1e-5));
  }
  EXPECT_THROW(layer_ends(plan, 0.05, 0.2), UsageError);
}

TEST(LayerEnds, AWholeNumberOfUsualLayersIsNotRaisedByRounding) {
  EXPECT_EQ(layer_ends({0, 1, {}, {}}, 0.3, 0.1).size(), 4u);
  EXPECT_EQ(layer_ends({0, 1, {}, {}}, 0.3 * (1 + 1e-5), 0.1).size(), 5u);
  EXPECT_EQ(layer_ends({0, 1, {}, {}}, 1e-9, 0.1), (std::vector<double>{0, 1}));
}

TEST(LayerEnds, GrowthDownwardsIsThatUpwardsReversed) {
  const std::vector<double> up = layer_ends({5, 1.3, {}, {}}, 1, 1), down = layer_ends({5, 1 / 1.3, {}, {}}, 1, 1);
  for (std::size_t k = 0; k < up.size(); ++k) EXPECT_NEAR(down[k], 1 - up[up.size() - 1 - k], 1e-15);
}

TEST(LayerEnds, TooManyUsualLayersAreRefused) {
  EXPECT_EQ(message_of<UsageError>([] {
              layer_ends({0, 1, {}, {}}, 1e6, 1);
            }),
            "layers as high as the quads are long would be 1e+06, more than 100000: give --layers or a shorter sweep");
  EXPECT_THROW(layer_ends({0, 1, {}, {}}, 1e300, 1e-300), UsageError) << "infinitely many";
}

TEST(LayerEnds, WallLayersNeedRoom) {
  LayerPlan plan;
  plan.bottom = layers::parse_layer_spec("--bottom-layers", "first=0.5,growth=1,layers=2");
  EXPECT_EQ(message_of<UsageError>([&] { layer_ends(plan, 1, 1); }),
            "--bottom-layers and --top-layers are 1 thick, but the sweep is 1 long: lower layers, first or growth");
  EXPECT_EQ(layer_ends(plan, 1.5, 1).size(), 4u);
}

TEST(LayerEnds, BetweenEqualWallLayersAreSymmetric) {
  LayerPlan plan{6, 1, {}, {}};
  plan.bottom = layers::parse_layer_spec("--bottom-layers", "first=0.01,growth=1.2,layers=4");
  plan.top = layers::parse_layer_spec("--top-layers", "first=0.01,growth=1.2,layers=4");
  const std::vector<double> ends = layer_ends(plan, 1, 1);
  ASSERT_EQ(ends.size(), 15u);
  EXPECT_TRUE(std::is_sorted(ends.begin(), ends.end()));
  for (std::size_t k = 0; k < ends.size(); ++k) EXPECT_NEAR(ends[k], 1 - ends[14 - k], 1e-12);
}

}  // namespace
}  // namespace quadrille::sweep
