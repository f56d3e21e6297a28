#include "sizing/metric_field.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {
namespace {

using Samples = std::vector<MetricSample>;

/// On a grid of points 0.1 apart in [0, 1]^2.
template <class Lengths>
Samples grid(const Lengths& lengths) {
  Samples samples;
  for (int i = 0; i <= 10; ++i)
    for (int j = 0; j <= 10; ++j) {
      MetricSample sample = lengths(Vec2{0.1 * i, 0.1 * j});
      sample.position = {0.1 * i, 0.1 * j};
      samples.push_back(sample);
    }
  return samples;
}

SizeField of(Samples samples, double growth = 1.2, double greatest = 10) {
  SizeSources sources;
  sources.metric = std::move(samples);
  return {greatest, sources, {}, growth};
}

TEST(MetricField, OfOneSampleIsThatEverywhere) {
  const SizeField sizes = of({{{0.3, 0.2}, 0.4, 0.1, pi / 6}});
  EXPECT_FALSE(sizes.is_uniform());
  for (const Vec2 x : {Vec2{}, Vec2{0.3, 0.2}, Vec2{5, -7}}) {
    EXPECT_NEAR(sizes.at(x), 0.2, 1e-15);
    EXPECT_NEAR(sizes.along(unit(pi / 6), x), 0.4, 1e-14);
    EXPECT_NEAR(sizes.along(unit(pi / 6 + half_pi), x), 0.1, 1e-14);
    EXPECT_NEAR(sizes.along(unit(pi / 6 + pi / 4), x), std::sqrt(2 / (1 / 0.16 + 1 / 0.01)), 1e-14);
    EXPECT_NEAR(sizes.directed(x).least(), 0.1, 1e-15);
    EXPECT_NEAR(det(sizes.directed(x).stretch), 1, 1e-14);
  }
  const Vec2 direction = direction_of(sizes.directed({}));
  EXPECT_NEAR(norm(direction), 0.36, 1e-14);
  EXPECT_NEAR(distance(direction, 0.36 * unit(4 * pi / 6)), 0, 1e-14);
}

TEST(MetricField, OfEqualSamplesIsTheirsBetweenAndBeyondThem) {
  const SizeField sizes = of(grid([](Vec2) { return MetricSample{{}, 0.2, 0.05, 0.3}; }));
  for (const Vec2 x : {Vec2{0.5, 0.5}, Vec2{0.05, 0.95}, Vec2{0.33, 0.71}, Vec2{4, -3}}) {
    EXPECT_NEAR(sizes.along(unit(0.3), x), 0.2, 1e-13);
    EXPECT_NEAR(sizes.along(unit(0.3 + half_pi), x), 0.05, 1e-13);
  }
}

TEST(MetricField, LengthsAreLimitedByOtherSizes) {
  const SizeField sizes = of({{{}, 0.4, 0.1, 0}}, 1.2, 0.2);
  EXPECT_NEAR(sizes.along({1, 0}, {}), 0.2, 1e-15);
  EXPECT_NEAR(sizes.along({0, 1}, {}), 0.1, 1e-15);
  EXPECT_NEAR(direction_of(of({{{}, 0.4, 0.1, 0}}, 1.2, 0.05).directed({})).x, 0, 1e-15);
}

TEST(MetricField, SamplesInOnePlaceCountAsTheirMean) {
  Samples samples = grid([](Vec2) { return MetricSample{{}, 0.2, 0.1, 0}; });
  const Samples once = samples;
  for (int k = 0; k < 20; ++k) samples.push_back(samples[60]);
  for (const Vec2 x : {Vec2{0.5, 0.5}, Vec2{0.52, 0.47}})
    EXPECT_NEAR(of(samples).along({1, 0}, x), of(once).along({1, 0}, x), 1e-14);
  const SizeField two = of({{{}, 0.1, 0.1, 0}, {{}, 0.4, 0.1, 0}});
  EXPECT_NEAR(two.along({1, 0}, {}), 0.2, 1e-14);
}

TEST(MetricField, FollowsALayerToHalfTheDistanceOfSamples) {
  const auto across = [](double y) { return 0.02 + 0.15 * std::abs(y - 0.5); };
  const SizeField sizes = of(grid([&](Vec2 x) { return MetricSample{{}, 0.1, across(x.y), 0}; }));
  for (const double y : {0.0, 0.2, 0.33, 0.8, 1.0}) EXPECT_NEAR(sizes.along({0, 1}, {0.47, y}), across(y), 0.01) << y;
  EXPECT_LT(sizes.along({0, 1}, {0.47, 0.5}), 0.03);
}

TEST(MetricField, LengthsGrowByAtMostTheGrowth) {
  // Fine across one line of points, so that the next ones may be longer there by 0.1 ln(1.2) only.
  const SizeField sizes = of(grid([](Vec2 x) {
    return MetricSample{{}, 1, std::abs(x.y - 0.5) < 0.01 ? 0.01 : 1, 0};
  }));
  for (const double y : {0.1, 0.3, 0.7, 0.9})
    EXPECT_LT(sizes.along({0, 1}, {0.5, y}), 0.01 + (std::abs(y - 0.5) + 0.1) * std::log(1.2));
  EXPECT_NEAR(sizes.along({1, 0}, {0.5, 0.5}), 1, 1e-12) << "along the line nothing is shorter";
}

TEST(MetricField, OfMirroredSamplesIsMirrored) {
  const SizeField sizes = of(grid([](Vec2 x) {
    const double y = x.y - 0.5;
    return MetricSample{{}, 0.3, 0.02 + 0.3 * y * y + 0.05 * x.x, 0.4 + y};
  }));
  const SizeField mirrored = of(grid([](Vec2 x) {
    const double y = 0.5 - x.y;
    return MetricSample{{}, 0.3, 0.02 + 0.3 * y * y + 0.05 * x.x, -(0.4 + y)};
  }));
  for (const Vec2 x : {Vec2{0.11, 0.2}, Vec2{0.5, 0.5}, Vec2{0.85, 0.95}, Vec2{2, 0.3}})
    for (const double angle : {0.0, 0.5, 1.5})
      EXPECT_NEAR(sizes.along(unit(angle), x), mirrored.along(unit(-angle), {x.x, 1 - x.y}), 1e-12);
}

}  // namespace
}  // namespace quadrille::sizing
