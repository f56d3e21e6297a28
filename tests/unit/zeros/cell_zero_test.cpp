#include "zeros/cell_zero.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::zeros {
namespace {

/// Two triangles on [0, 1]^2; element 0 is the lower right one.
Field field_with_zero(Vec2 zero) {
  return interpolated_field(square_mesh({0, 0}, 1, 1), 3, [=](Vec2 x) {
    const Vec2 d = x - zero;
    return Vec2{d.x + 0.1 * (d.x * d.x - d.y * d.y), d.y - 0.2 * d.x * d.y};
  });
}

struct CellZero {
  bool is_found = false;
  Vec2 x;
};

/// The zero in the whole of element 0.
CellZero zero_in_element(const Field& field) {
  const field::FieldEvaluator evaluator(field);
  const Cell cell = element_cell(evaluator, 0);
  Enclosure enclosure;
  enclosure.set(cell, {});
  Mat2 inverse_jacobian;
  double contraction = 0;
  EXPECT_TRUE(enclosure.isolates(inverse_jacobian, contraction));
  Vec2 xi;
  const bool is_found = find_cell_zero(evaluator, cell, inverse_jacobian, contraction, enclosure.value_noise(), xi);
  return {is_found, is_found ? evaluator.sample(0, xi).x : Vec2{}};
}

TEST(FindCellZero, FindsTheZeroInsideToRoundOff) {
  for (const Vec2 zero : {Vec2{0.6, 0.2}, Vec2{0.9, 0.85}, Vec2{0.99, 0.01}}) {
    const CellZero found = zero_in_element(field_with_zero(zero));
    ASSERT_TRUE(found.is_found) << zero.x;
    EXPECT_NEAR(distance(found.x, zero), 0, 1e-14);
  }
}

TEST(FindCellZero, FindsAZeroOnTheEdgeAndAtAVertex) {
  EXPECT_TRUE(zero_in_element(field_with_zero({0.5, 0.5})).is_found);
  EXPECT_TRUE(zero_in_element(field_with_zero({1, 1})).is_found);
}

TEST(FindCellZero, ProvesThatThereIsNoneBeyondTheEdge) {
  for (const Vec2 zero : {Vec2{0.4, 0.41}, Vec2{0.2, 0.7}, Vec2{0.5, -1e-4}, Vec2{-0.05, -0.05}})
    EXPECT_FALSE(zero_in_element(field_with_zero(zero)).is_found) << zero.x;
}

TEST(PolishZero, MayLeaveTheElementAndStopsWhereTheJacobianVanishes) {
  const Field field = field_with_zero({0.4, 0.5});
  const field::FieldEvaluator evaluator(field);
  Vec2 xi;
  evaluator.maps()[0].invert({0.45, 0.42}, xi);  // beside the zero, in element 0; the zero itself is in element 1
  ASSERT_TRUE(polish_zero(evaluator, 0, xi));
  EXPECT_NEAR(distance(evaluator.sample(0, xi).x, {0.4, 0.5}), 0, 1e-14);
  EXPECT_GT(mesh::outside_reference(xi), 0);
  const Field constant = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  EXPECT_FALSE(polish_zero(field::FieldEvaluator(constant), 0, xi));
}

}  // namespace
}  // namespace quadrille::zeros
