#include "zeros/surely_empty.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"

namespace quadrille::zeros {
namespace {

int num_surely_empty(const Field& field, double margin) {
  const field::FieldEvaluator evaluator(field);
  int count = 0;
  for (int e = 0; e < field.mesh.num_elems(); ++e) count += is_surely_empty(evaluator, e, margin);
  return count;
}

TEST(SurelyEmpty, holds_where_the_field_is_longer_than_the_margin) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 4), 3, [](Vec2 x) { return Vec2{2 + x.x, x.y}; });
  EXPECT_EQ(num_surely_empty(field, 0), field.mesh.num_elems());
  EXPECT_EQ(num_surely_empty(field, 0.5), field.mesh.num_elems());
}

TEST(SurelyEmpty, does_not_hold_where_there_is_a_zero_or_may_be_one) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 4), 3, [](Vec2 x) { return x - Vec2{0.31, 0.17}; });
  EXPECT_LT(num_surely_empty(field, 0), field.mesh.num_elems());
  EXPECT_EQ(num_surely_empty(field, 10), 0);
}

}  // namespace
}  // namespace quadrille::zeros
