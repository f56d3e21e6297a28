#include "zeros/cell.hpp"

#include <gtest/gtest.h>

#include "../support/bernstein_value.hpp"
#include "../support/square_field.hpp"
#include "../test_meshes.hpp"
#include "zeros/enclosure.hpp"

namespace quadrille::zeros {
namespace {

Vec2 value_of(Vec2 x) { return {1 + x.x * x.x - x.y, 2 * x.x * x.y - 0.5}; }

/// Position and field of a cell at local coordinates.
std::array<double, 4> evaluated(const Cell& cell, Vec2 lambda) {
  std::array<double, 4> values;
  for (int c = 0; c < 4; ++c)
    values[c] =
        spectral::bernstein_value(cell.degree, cell.components[c], {1 - lambda.x - lambda.y, lambda.x, lambda.y});
  return values;
}

const std::array<Vec2, 5> samples{Vec2{0, 0}, {1, 0}, {0, 1}, {0.3, 0.2}, {0.1, 0.7}};

/// The cell's position and field are those of the element there.
void expect_same(const field::FieldEvaluator& evaluator, const Cell& cell) {
  for (const Vec2 lambda : samples) {
    const std::array<double, 4> values = evaluated(cell, lambda);
    const field::FieldSample sample = evaluator.sample(cell.elem, cell.xi_at(lambda));
    EXPECT_NEAR(distance({values[0], values[1]}, sample.x), 0, 1e-13);
    EXPECT_NEAR(distance({values[2], values[3]}, sample.value), 0, 1e-13);
  }
}

TEST(Cell, OfAStraightElementHasItsVerticesAndField) {
  for (const int order : {2, 5}) {
    const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), order, value_of);
    const field::FieldEvaluator evaluator(field);
    const Cell cell = element_cell(evaluator, 1);
    EXPECT_EQ(cell.elem, 1);
    EXPECT_EQ(cell.degree, order);
    EXPECT_EQ(cell.num_coefs(), spectral::num_bernstein(order));
    for (int k = 0; k < 3; ++k)
      EXPECT_NEAR(distance(cell.vertex(k), field.mesh.vertices[field.mesh.elem2vertices[1][k]]), 0, 1e-15);
    expect_same(evaluator, cell);
  }
}

TEST(Cell, OfACurvedElementHasTheGreaterDegreeOfBoth) {
  for (const int order : {2, 9}) {
    const Field field = interpolated_field(disc_mesh(5, 6), order, value_of);
    const field::FieldEvaluator evaluator(field);
    const Cell cell = element_cell(evaluator, 2);
    EXPECT_EQ(cell.degree, std::max(order, 6));
    expect_same(evaluator, cell);
  }
}

TEST(Cell, TheScaleIsTheGreatestCoefficient) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 3, [](Vec2) { return Vec2{3, -4}; });
  EXPECT_NEAR(element_cell(field::FieldEvaluator(field), 0).scale, 5, 1e-14);
}

TEST(Bisect, CutsTheLongestSideInThePlane) {
  // The diagonal of a square is the longest side of both triangles.
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 3, value_of);
  const field::FieldEvaluator evaluator(field);
  for (const int elem : {0, 1}) {
    const Cell cell = element_cell(evaluator, elem);
    Cell first, second;
    bisect(cell, first, second);
    const auto has_middle = [](const Cell& half) {
      for (int k = 0; k < 3; ++k)
        if (distance(half.vertex(k), {0.5, 0.5}) < 1e-15) return true;
      return false;
    };
    EXPECT_TRUE(has_middle(first));
    EXPECT_TRUE(has_middle(second));
    for (const Cell* half : {&first, &second}) {
      expect_same(evaluator, *half);
      EXPECT_EQ(half->elem, elem);
      EXPECT_EQ(half->degree, cell.degree);
      EXPECT_EQ(half->scale, cell.scale) << "of the element";
    }
  }
}

TEST(Bisect, HalvesTheAreaAndKeepsTheOrientationAgainAndAgain) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 2, value_of);
  const field::FieldEvaluator evaluator(field);
  const auto area = [](const Cell& c) { return cross(c.vertex(1) - c.vertex(0), c.vertex(2) - c.vertex(0)) / 2; };
  Cell cell = element_cell(evaluator, 0);
  for (int depth = 1; depth <= 6; ++depth) {
    Cell first, second;
    bisect(cell, first, second);
    EXPECT_NEAR(area(first), std::ldexp(0.5, -depth), 1e-15);
    EXPECT_NEAR(area(second), std::ldexp(0.5, -depth), 1e-15);
    expect_same(evaluator, second);
    cell = depth % 2 == 0 ? first : second;
  }
}

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
  ASSERT_TRUE(polish_zero([&](Vec2 at) { return evaluator.sample(0, at); }, xi));
  EXPECT_NEAR(distance(evaluator.sample(0, xi).x, {0.4, 0.5}), 0, 1e-14);
  EXPECT_GT(mesh::outside_reference(xi), 0);
  const Field constant = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator flat(constant);
  EXPECT_FALSE(polish_zero([&](Vec2 at) { return flat.sample(0, at); }, xi));
}

}  // namespace
}  // namespace quadrille::zeros
