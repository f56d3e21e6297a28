#include "zeros/far_liftings.hpp"

#include <gtest/gtest.h>

#include "../support/polygon_field.hpp"
#include "field/explicit_value.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::zeros {
namespace {

/// A star: corners alternate between two radii, which gives each a lifting. It is stretched, so that all zeros are
/// simple.
Field star_field(int corners) {
  std::vector<Vec2> points;
  for (int k = 0; k < corners; ++k) {
    const Vec2 x = (k % 2 == 0 ? 10 : 9.85) * unit(2 * pi * k / corners);
    points.push_back({1.4 * x.x, x.y});
  }
  return adapted_field(polygon_face(points));
}

TEST(FarLiftings, near_ones_and_the_series_add_up_to_all_with_their_gradients) {
  const Field field = star_field(80);
  ASSERT_GE(field.liftings.size(), 64u);
  const field::FieldEvaluator evaluator(field);
  FarLiftings groups(evaluator);
  int num_far = 0;
  for (int e = 0; e < field.mesh.num_elems(); e += 7) {
    const LiftingGroup& group = groups.of(e);
    const Vec2 x = evaluator.maps()[e].position({-0.5, -0.2});
    ASSERT_TRUE(group.contains(x, 0));
    Vec2 all;
    Mat2 gradient, slope;
    const auto add = [](const Lifting& lifting, Vec2 at, Vec2& sum, Mat2& slopes) {
      const Vec2 g = field::lifting_gradient(lifting, at);
      sum += field::lifting_angle(lifting, at) * lifting.jump;
      slopes = {slopes.xx + lifting.jump.x * g.x, slopes.xy + lifting.jump.x * g.y, slopes.yx + lifting.jump.y * g.x,
                slopes.yy + lifting.jump.y * g.y};
    };
    for (const Lifting& lifting : field.liftings) add(lifting, x, all, gradient);
    Vec2 sum = group.far_sum(x, slope);
    for (const Lifting& lifting : group.near_liftings) add(lifting, x, sum, slope);
    EXPECT_LT(distance(sum, all), 1e-12);
    const Mat2 error{slope.xx - gradient.xx, slope.xy - gradient.xy, slope.yx - gradient.yx, slope.yy - gradient.yy};
    EXPECT_LT(frobenius_norm(error), 1e-12 * (1 + frobenius_norm(gradient)));
    num_far += static_cast<int>(field.liftings.size() - group.near_liftings.size());
  }
  EXPECT_GT(num_far, 0);
}

TEST(FarLiftings, a_search_with_series_finds_the_index_sum) {
  const Field field = star_field(80);
  const field::FieldEvaluator evaluator(field);
  ZeroSearch search(evaluator, {});
  for (int e = 0; e < field.mesh.num_elems(); ++e) search.search(e);
  EXPECT_TRUE(search.open_cells().empty());
  int sum = 0;
  for (const FoundZero& zero : distinct_zeros(evaluator, search.zeros())) sum += zero.index;
  // The angles of all corners lie between 135 and 225 degrees: their valence is 2.
  EXPECT_EQ(sum, 4);
}

TEST(FarLiftings, samples_are_those_of_the_evaluator_after_jumps_have_changed_too) {
  Field field = star_field(80);
  const field::FieldEvaluator evaluator(field);
  FarLiftings groups(evaluator);
  const Vec2 xi{-0.4, -0.3};
  const auto inverse_slope = [](const field::FieldSample& s) { return frobenius_norm(inverse(s.dv_dx)); };
  for (const double factor : {1.0, -2.0}) {
    for (Lifting& lifting : field.liftings) lifting.jump *= factor;
    groups.renew();
    for (int e = 0; e < field.mesh.num_elems(); e += 11) {
      const field::FieldSample here = groups.sample(e, xi), expected = evaluator.sample(e, xi);
      EXPECT_LT(distance(here.value, expected.value), 1e-12);
      EXPECT_LT(distance(here.x, expected.x), 1e-15);
      EXPECT_NEAR(inverse_slope(here), inverse_slope(expected), 1e-8 * inverse_slope(expected));
    }
  }
}

TEST(FarLiftings, few_liftings_are_all_near) {
  const Field field = star_field(10);
  const field::FieldEvaluator evaluator(field);
  FarLiftings groups(evaluator);
  EXPECT_EQ(groups.of(0).near_liftings.size(), field.liftings.size());
  EXPECT_EQ(groups.of(0).jumps, 0);
}

}  // namespace
}  // namespace quadrille::zeros
