#include <gtest/gtest.h>

#include <cmath>

#include "../chart_samples.hpp"
#include "square_samples.hpp"

namespace quadrille::draw {
namespace {

TEST(DrawChart, ShowsEveryTriangleWithItsScale) {
  const std::string svg = draw_stage(samples::charted_face(), {});
  expect_sound(svg);
  expect_counts(svg, {{"id=\"elem-", 2}, {"<title>triangle 1 of surface 0, scale ", 1}, {"<title>boundary curve", 4}});
  // 2 / (1 + r^2), from the middle of the sphere to the corner (1/2, 1/2) of the chart.
  EXPECT_EQ(count(svg, "2 triangles of order 2; lengths in space are 1.33 to 2 times those in the chart"), 1);
  EXPECT_EQ(svg, draw_stage(samples::charted_face(), {}));
}

/// Of a plane face in its own chart all scales are one.
TEST(DrawChart, AFaceOfOneScaleIsNoDivisionByZero) {
  ChartedFace charted = samples::charted_face();
  Chart chart = *charted.face.chart;
  chart.log_scale.assign(chart.log_scale.size(), 0);
  charted.face.chart = std::make_shared<const Chart>(chart);
  const std::string svg = draw_stage(charted, {});
  expect_sound(svg);
  EXPECT_EQ(count(svg, "lengths in space are 1 to 1 times those in the chart"), 1);
}

}  // namespace
}  // namespace quadrille::draw
