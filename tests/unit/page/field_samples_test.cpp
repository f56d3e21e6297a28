#include "page/field_samples.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "../support/square_field.hpp"

namespace quadrille::page {
namespace {

const PageFrame frame = page_frame({{-1, -1}, {1, 1}});

/// On the square [-1, 1]^2.
FieldSamples samples_of(int order, const std::function<Vec2(Vec2)>& value) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), order, value);
  return field_samples(draw::RegionFields(field), frame);
}

/// One triangle as the page reads it.
struct Triangle {
  LatticeForm form;
  std::array<Vec2, 3> corners;
  std::vector<Vec2> values;
  Vec2 position(double s, double t) const { return (1 - s - t) * corners[0] + s * corners[1] + t * corners[2]; }
};

std::vector<Triangle> unpacked(const FieldSamples& samples) {
  std::vector<Triangle> triangles;
  std::size_t point = 0, value = 0;
  for (std::size_t e = 0; e < samples.forms.size(); ++e) {
    Triangle& triangle = triangles.emplace_back();
    triangle.form = {samples.forms[e] & 7, samples.forms[e] >> 3 & 15};
    for (Vec2& corner : triangle.corners) {
      corner = frame.centre + frame.step * Vec2{double(samples.points[point]), double(samples.points[point + 1])};
      point += 2;
    }
    for (int p = 0; p < triangle.form.num_points(); ++p, value += 2)
      triangle.values.push_back({samples.scales[2 * e] * samples.values[value] / 32767,
                                 samples.scales[2 * e + 1] * samples.values[value + 1] / 32767});
  }
  EXPECT_EQ(point, samples.points.size());
  EXPECT_EQ(value, samples.values.size());
  return triangles;
}

/// The greatest distance, in pixels, by which the contour u = 0 of the drawing is displaced, of `u` with the
/// `gradient`.
double greatest_displacement(const FieldSamples& samples, const std::function<double(Vec2)>& u,
                             const std::function<Vec2(Vec2)>& gradient) {
  double greatest = 0;
  for (const Triangle& triangle : unpacked(samples))
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; i + j <= 40; ++j) {
        const double s = i / 40.0, t = j / 40.0;
        const Vec2 x = triangle.position(s, t);
        if (std::abs(u(x)) > 0.05 * norm(gradient(x))) continue;
        const double error = std::abs(drawn_value(triangle.form, triangle.values, s, t).x - u(x));
        greatest = std::max(greatest, error / norm(gradient(x)) / frame.pixel(x));
      }
  return greatest;
}

TEST(FieldSamples, ContoursLieWithinAPixelOfTheFirstView) {
  const auto u = [](Vec2 x) { return norm2(x) - 0.49; };
  const FieldSamples circle = samples_of(2, [&](Vec2 x) { return Vec2{u(x), 1}; });
  EXPECT_LT(greatest_displacement(circle, u, [](Vec2 x) { return 2 * x; }), 0.5);
  const auto wave = [](Vec2 x) { return std::sin(5 * x.x) * std::cos(4 * x.y) - 0.3 * x.y; };
  const FieldSamples waves = samples_of(12, [&](Vec2 x) { return Vec2{wave(x), x.x}; });
  EXPECT_LT(
      greatest_displacement(
          waves, wave,
          [](Vec2 x) {
            return Vec2{5 * std::cos(5 * x.x) * std::cos(4 * x.y), -4 * std::sin(5 * x.x) * std::sin(4 * x.y) - 0.3};
          }),
      1);
}

TEST(FieldSamples, WhatIsLinearHasOneCubicOfFewLines) {
  const FieldSamples samples = samples_of(3, [](Vec2 x) { return x; });
  for (const std::uint8_t form : samples.forms) EXPECT_EQ(form, 1 + 8 * 2);
  EXPECT_EQ(samples.values.size(), 20 * samples.forms.size());
}

TEST(FieldSamples, CubicsAreExact) {
  const auto cubic = [](double s, double t) { return s * s * s - 2 * s * t * t + t - 0.25; };
  for (const LatticeForm form : {LatticeForm{1, 4}, LatticeForm{2, 4}, LatticeForm{4, 8}}) {
    std::vector<Vec2> values;
    const int n = form.intervals(), drawn = form.parts * form.lines;
    for (int j = 0; j <= n; ++j)
      for (int i = 0; i + j <= n; ++i) values.push_back({cubic(double(i) / n, double(j) / n), 1});
    for (int j = 0; j <= drawn; ++j)
      for (int i = 0; i + j <= drawn; ++i) {
        const double s = double(i) / drawn, t = double(j) / drawn;
        EXPECT_NEAR(drawn_value(form, values, s, t).x, cubic(s, t), 1e-12) << form.parts << " at " << s << ", " << t;
      }
  }
}

TEST(FieldSamples, ABodyInAFarFieldHasSmallerPixels) {
  PageFrame far = page_frame({{-20, -20}, {20, 20}});
  far.body = {{0, -0.1}, {1, 0.1}};
  EXPECT_DOUBLE_EQ(far.pixel({0.5, 0}), 1.0 / 800);
  EXPECT_DOUBLE_EQ(far.pixel({10, 0}), 40.0 / 800);
}

}  // namespace
}  // namespace quadrille::page
