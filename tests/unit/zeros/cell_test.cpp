#include "zeros/cell.hpp"

#include <gtest/gtest.h>

#include "../support/bernstein_value.hpp"
#include "../support/square_field.hpp"
#include "../test_meshes.hpp"

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

}  // namespace
}  // namespace quadrille::zeros
