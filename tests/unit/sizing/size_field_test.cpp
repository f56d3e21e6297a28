#include "sizing/size_field.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "../chart_samples.hpp"
#include "base/error.hpp"

namespace quadrille::sizing {
namespace {

constexpr double growth = 1.3;
const double slope = std::log(growth);

SizeField of_points(const std::vector<SizeBall>& points) { return SizeField(1, {points, {}, 0}, {}, growth); }

TEST(SizeField, WithoutSourcesIsTheSameEverywhere) {
  const SizeField field(0.3);
  EXPECT_TRUE(field.is_uniform());
  EXPECT_EQ(field.at({1e9, -3}), 0.3);
  EXPECT_TRUE(of_points({{{0, 0}, 1, 0}, {{0, 0}, 7, 0}}).is_uniform()) << "sources above the greatest size";
}

TEST(SizeField, GrowsFromPointsAndTheirDiscs) {
  const SizeField field = of_points({{{2, 1}, 0.1, 0.5}});
  EXPECT_EQ(field.at({2, 1}), 0.1);
  EXPECT_EQ(field.at({2.5, 1}), 0.1);
  EXPECT_NEAR(field.at({2, 2}), 0.1 + slope * 0.5, 1e-15);
  EXPECT_EQ(field.at({50, 0}), 1);
}

TEST(SizeField, GrowsFromBoxes) {
  const SizeField field(1, {{}, {{{0, 0}, {2, 1}, 0.2}}, 0}, {}, growth);
  EXPECT_EQ(field.at({1.9, 0.1}), 0.2);
  EXPECT_NEAR(field.at({1, 1.5}), 0.2 + slope * 0.5, 1e-15);
  EXPECT_NEAR(field.at({5, 5}), 1, 1e-15);
  EXPECT_NEAR(field.at({3, 2}), 0.2 + slope * std::sqrt(2), 1e-15);
}

TEST(SizeField, ElementsInARowGrowByTheFactor) {
  // Elements of wanted length: each ends where the integral of 1 / h is a whole number.
  const SizeField field = of_points({{{0, 0}, 0.01, 0}});
  double x = 0, before = 0;
  for (int elem = 0; elem < 6; ++elem) {
    const double start = x;
    for (int step = 0; step < 100000; ++step) x += field.at({x, 0}) / 100000;
    if (elem > 0) {
      EXPECT_NEAR((x - start) / before, growth, 1e-3);
    }
    before = x - start;
  }
}

TEST(SizeField, SegmentsAreTheLeastOverTheirPoints) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> number(-1, 1);
  for (int trial = 0; trial < 300; ++trial) {
    const SizeSegment s{{number(random), number(random)},
                        {number(random), number(random)},
                        0.3 + 0.2 * number(random),
                        0.3 + 0.2 * number(random)};
    const SizeField field(10, {}, {s}, growth);
    const Vec2 x{2 * number(random), 2 * number(random)};
    double least = 1e300;
    for (int k = 0; k <= 2000; ++k) {
      const double t = k / 2000.0;
      least =
          std::min(least, (1 - t) * s.size_a + t * s.size_b + slope * distance(in_space(x), (1 - t) * s.a + t * s.b));
    }
    EXPECT_LE(field.at(x), least + 1e-12);
    EXPECT_GE(field.at(x), least - 1e-3);
  }
}

TEST(SizeField, ManySourcesAreTheLeastOfEach) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> number(0, 1);
  SizeSources sources;
  for (int k = 0; k < 500; ++k) {
    sources.points.push_back({{number(random), number(random)}, 0.01 + 0.2 * number(random), 0.01 * number(random)});
    const Vec3 low{number(random), number(random)};
    sources.boxes.push_back({low, low + Vec3{0.01, 0.02, 0}, 0.01 + 0.2 * number(random)});
  }
  const SizeField field(1, sources, {}, growth);
  for (int trial = 0; trial < 200; ++trial) {
    const Vec2 x{number(random), number(random)};
    double least = 1;
    for (const SizeBall& p : sources.points) least = std::min(least, of_points({p}).at(x));
    for (const SizeBox& b : sources.boxes) least = std::min(least, SizeField(1, {{}, {b}, 0}, {}, growth).at(x));
    EXPECT_NEAR(field.at(x), least, 1e-15);
  }
}

TEST(SizeField, ImpossibleSizesAreUsageErrors) {
  EXPECT_THROW(SizeField(0), UsageError);
  EXPECT_THROW(of_points({{{0, 0}, 0, 0}}), UsageError);
  EXPECT_THROW(SizeField(1, {{{{0, 0}, 0.1, 0}}, {}, 0}, {}, 1), UsageError);
}

TEST(SizeField, IsLinearInATriangleAndGrowsOutsideOfIt) {
  SizeSources sources;
  sources.triangles = {{{Vec3{0, 0}, {1, 0}, {0, 1}}, {0.1, 0.2, 0.15}}};
  const SizeField sizes(10, sources, {}, growth);
  EXPECT_NEAR(sizes.at({0.25, 0.5}), 0.1 + 0.25 * 0.1 + 0.5 * 0.05, 1e-14);
  EXPECT_NEAR(sizes.at({1, 0}), 0.2, 1e-14);
  EXPECT_NEAR(sizes.at({0, -3}), 0.1 + 3 * slope, 0.05) << "near the finest corner";
  EXPECT_LE(sizes.at({0, -3}), 0.1 + 3 * slope);
  // The least over the triangle of size + slope * distance, by brute force.
  for (const Vec2 x : {Vec2{1, 1}, {-0.3, 0.2}, {0.6, -0.1}, {0.1, 0.1}}) {
    double least = 1e300;
    for (int i = 0; i <= 400; ++i)
      for (int j = 0; i + j <= 400; ++j) {
        const Vec2 p{i / 400.0, j / 400.0};
        least = std::min(least, 0.1 + 0.1 * p.x + 0.05 * p.y + slope * distance(x, p));
      }
    EXPECT_NEAR(sizes.at(x), least, 1e-3 * slope);
    EXPECT_LE(sizes.at(x), least + 1e-12);
  }
}

TEST(SizeField, ATriangleThatIsTooSteepIsLimited) {
  SizeSources sources;
  sources.triangles = {{{Vec3{0, 0}, {1, 0}, {0, 1}}, {0.1, 5, 5}}};
  const SizeField sizes(10, sources, {}, 1.2);
  EXPECT_NEAR(sizes.at({0.5, 0}), 0.1 + 0.5 * std::log(1.2), 1e-12);
  EXPECT_NEAR(sizes.at({0.3, 0.4}), 0.1 + 0.5 * std::log(1.2), 1e-12);
}

TEST(SizeField, OnACurvedFaceSourcesAndDistancesAreThoseOfSpace) {
  // Sources at the north pole of the unit sphere, the middle of the chart.
  SizeSources sources;
  sources.points = {{{0, 0, 1}, 0.01, 0}};
  sources.boxes = {{{0.7, -1, -1}, {0.8, 1, 1}, 0.02}};
  sources.is_in_space = true;
  const SizeField sizes = SizeField(10, sources, {}, growth).in_chart(chart_scale(samples::sphere_face(2, 10)));
  for (const Vec2 x : {Vec2{0.1, 0.2}, {0.3, 0}, {0.25, 0.4}}) {
    const Vec3 there = samples::on_sphere(x);
    const double size =
        std::min(0.01 + slope * distance(there, {0, 0, 1}), 0.02 + slope * std::max(0.0, 0.7 - there.x));
    EXPECT_NEAR(sizes.at(x) * std::exp(samples::sphere_log_scale(x)), size, 1e-6);
  }
}

TEST(SizeField, TrianglesInSpaceGrowAwayFromTheirPlane) {
  SizeSources sources;
  sources.triangles = {{{Vec3{0, 0, 1}, {3, 0, 1}, {0, 3, 1}}, {0.1, 0.1, 0.1}}};
  EXPECT_NEAR(SizeField(10, sources, {}, growth).at({1, 1}), 0.1 + slope, 1e-14);
}

}  // namespace
}  // namespace quadrille::sizing
