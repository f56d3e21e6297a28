#include "guide/zeros_in_circle.hpp"

#include <gtest/gtest.h>

#include <complex>

#include "../support/square_field.hpp"

namespace quadrille::guide {
namespace {

using Complex = std::complex<double>;

TEST(MomentCentre, is_the_centroid_of_the_zeros_that_a_small_term_splits) {
  const Vec2 at{0.1, -0.2};
  const std::vector<std::pair<int, double>> cases{{2, 1e-6}, {3, 1e-8}, {4, 1e-10}, {-2, 1e-6}, {-3, 1e-8}};
  for (const auto& one : cases) {
    const int index = one.first;
    const double e = one.second;
    const Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 5, [&](Vec2 x) {
      const Complex z{x.x - at.x, x.y - at.y}, w = std::pow(z, std::abs(index)) * (1.0 + 0.3 * z) + e;
      return Vec2{w.real(), index > 0 ? w.imag() : -w.imag()};
    });
    const auto centre = moment_centre(field::FieldEvaluator(field), at + Vec2{1e-3, 2e-3}, index, 0.01, 0.5);
    ASSERT_TRUE(centre.has_value());
    EXPECT_NEAR(distance(*centre, at), 0, 10 * e) << index;  // the zeros themselves are e^(1/n) away
  }
}

TEST(MomentCentre, is_none_where_no_circle_shows_the_index_alone) {
  // A simple zero, and two that are too far apart for the circles.
  const Field simple = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2 x) { return x; });
  EXPECT_FALSE(moment_centre(field::FieldEvaluator(simple), {0, 0}, 2, 0.01, 0.5).has_value());
  const Field pair = interpolated_field(square_mesh({-1, -1}, 2, 2), 2, [](Vec2 x) {
    const Complex w = std::pow(Complex(x.x, x.y), 2) - 0.16;
    return Vec2{w.real(), w.imag()};
  });
  EXPECT_FALSE(moment_centre(field::FieldEvaluator(pair), {0, 0}, 2, 0.01, 0.5).has_value());
}

TEST(MomentCentre, is_none_farther_than_the_inner_radius) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 2, [](Vec2 x) {
    const Complex w = std::pow(Complex(x.x, x.y), 2);
    return Vec2{w.real(), w.imag()};
  });
  EXPECT_TRUE(moment_centre(field::FieldEvaluator(field), {0.02, 0}, 2, 0.03, 0.5).has_value());
  EXPECT_FALSE(moment_centre(field::FieldEvaluator(field), {0.02, 0}, 2, 0.01, 0.5).has_value());
}

}  // namespace
}  // namespace quadrille::guide
