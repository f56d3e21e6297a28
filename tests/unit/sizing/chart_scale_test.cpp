#include "sizing/chart_scale.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {
namespace {

TEST(ChartScale, PlacesAndLengthsAreThoseOfSpace) {
  const ChartScale scale(samples::sphere_face(2, 8));
  for (const Vec2 x : {Vec2{0.2, 0.3}, {0.01, 0.02}, {0.44, 0.13}, {0, 0}, {0.5, 0.2}, {0.5, 0.5}}) {
    EXPECT_NEAR(scale.at(x).scale / std::exp(samples::sphere_log_scale(x)), 1, 1e-6);
    EXPECT_LE(distance(scale.at(x).position, samples::on_sphere(x)), 1e-6);
  }
  EXPECT_NEAR(scale.least(), 4.0 / 3, 1e-6);
  // |grad lambda| = 2 r / (1 + r^2) in the chart, in space r: greatest in the corner.
  EXPECT_NEAR(scale.greatest_gradient(), std::sqrt(0.5), 1e-4);
}

TEST(ChartScale, TheDiameterIsThatInSpace) {
  EXPECT_EQ(diameter_in_space(samples::face()), samples::face().diameter);
  EXPECT_NEAR(diameter_in_space(samples::sphere_face()),
              distance(samples::on_sphere({0, 0}), samples::on_sphere({0.5, 0.5})), 1e-12);
}

TEST(ChartScale, LengthsOfCurvesAreThoseInSpace) {
  EXPECT_NEAR(boundary_length(samples::sphere_face(), 0), 2 * std::atan(0.5), 1e-12);
  EXPECT_NEAR(boundary_length(samples::face(), 0), 1, 1e-15);
}

TEST(ChartScale, SizesAreLengthsInSpace) {
  const SizeField sizes = SizeField(0.1).in_chart(chart_scale(samples::sphere_face()));
  EXPECT_FALSE(sizes.is_uniform());
  EXPECT_NEAR(sizes.at({0.25, 0.25}), 0.1 * (1 + 0.125) / 2, 1e-6);
  EXPECT_EQ(sizes.at({0.25, 0.25}), sizes.greatest_at({0.25, 0.25}));
  EXPECT_EQ(sizes.greatest_in_space(), 0.1);
  EXPECT_NEAR(sizes.greatest(), 0.1 * 3 / 4, 1e-6);
  EXPECT_EQ(chart_scale(samples::face()), nullptr);
}

}  // namespace
}  // namespace quadrille::sizing
