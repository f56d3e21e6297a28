#include "offset/offset_profile.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "offset/wall_chains.hpp"

namespace quadrille::offset {

namespace {

RatioSamples with_a_gap(bool is_closed) {
  RatioSamples samples{is_closed, {}, {}, {}, {0, 100}, 0.5};
  for (int k = 0; k <= 100; ++k) {
    samples.lengths.push_back(0.2 * k);
    samples.ratios.push_back(k == 50 ? 0.5 : 1);
    samples.positions.push_back({0.2 * k, 0});
  }
  return samples;
}

TEST(SmoothedRatio, IsOneWhereNothingLimitsIt) {
  RatioSamples samples = with_a_gap(true);
  samples.ratios[50] = 1;
  const SmoothRatios smooth = smoothed_ratios(samples);
  for (int k = 0; k <= 100; ++k) {
    EXPECT_NEAR(smooth.ratios[k], 1, 1e-12);
    EXPECT_NEAR(smooth.slopes[k], 0, 1e-12);
  }
}

TEST(SmoothedRatio, StaysBelowTheRatiosWithALimitedSlope) {
  for (const bool is_closed : {false, true}) {
    const RatioSamples samples = with_a_gap(is_closed);
    const SmoothRatios smooth = smoothed_ratios(samples);
    for (int k = 0; k <= 100; ++k) {
      EXPECT_LE(smooth.ratios[k], samples.ratios[k] + 1e-12);
      EXPECT_LE(std::abs(smooth.slopes[k]) * samples.distance, offset_constants.greatest_slope + 1e-12);
      EXPECT_NEAR(smooth.ratios[k], smooth.ratios[100 - k], 1e-12) << "the mirror image";
    }
    EXPECT_NEAR(smooth.ratios[50], 0.5, 1e-2);
    EXPECT_NEAR(smooth.ratios[0], 1, 1e-12);
  }
}

}  // namespace

}  // namespace quadrille::offset
