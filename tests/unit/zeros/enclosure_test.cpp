#include "zeros/enclosure.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "field/boundary_values.hpp"

namespace quadrille::zeros {
namespace {

Vec2 wavy(Vec2 p) {
  return {std::cos(2 * p.x) * std::cosh(2 * p.y) - 0.7, 0.4 - std::sin(2 * p.x) * std::sinh(2 * p.y)};
}

/// Polynomial part and three liftings: at a corner of the square, on its edge, beyond it.
Field lifted_field() {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 7, wavy);
  field.liftings = {{0, {-1, -1}, {-1.3, -1.3}, {0.6, -0.4}},
                    {1, {0, -1}, {0, -1.5}, {-0.3, 0.5}},
                    {2, {1.2, 0.3}, {1.6, 0.3}, {0.2, 0.2}}};
  return field;
}

/// Visits all cells of the first `depth` halvings of all elements.
template <typename Visit>
void for_each_cell(const field::FieldEvaluator& evaluator, int depth, const Visit& visit) {
  const std::function<void(const Cell&, int)> descend = [&](const Cell& cell, int level) {
    visit(cell);
    if (level == depth) return;
    Cell first, second;
    bisect(cell, first, second);
    descend(first, level + 1);
    descend(second, level + 1);
  };
  for (int e = 0; e < evaluator.field().mesh.num_elems(); ++e) descend(element_cell(evaluator, e), 0);
}

std::vector<Vec2> lambdas() {
  std::vector<Vec2> points;
  for (int i = 0; i <= 6; ++i)
    for (int j = 0; i + j <= 6; ++j) points.push_back({i / 6.0, j / 6.0});
  return points;
}

struct EnclosureTest : testing::Test {
  Field field = lifted_field();
  field::FieldEvaluator evaluator{field};
};

TEST_F(EnclosureTest, an_excluded_cell_has_its_values_on_one_side_of_zero) {
  int excluded = 0, kept = 0;
  for_each_cell(evaluator, 5, [&](const Cell& cell) {
    Enclosure enclosure;
    enclosure.set(cell, field.liftings);
    if (!enclosure.excludes_zero()) {
      ++kept;
      return;
    }
    ++excluded;
    // The directions of the values lie within a half plane: less than pi from each other's mean.
    Vec2 mean;
    std::vector<Vec2> values;
    for (const Vec2 lambda : lambdas()) {
      values.push_back(evaluator.sample(cell.elem, cell.xi_at(lambda)).value);
      mean += normalized(values.back());
    }
    double low = 0, high = 0;
    for (const Vec2 v : values) {
      const double angle = std::atan2(cross(mean, v), dot(mean, v));
      low = std::min(low, angle);
      high = std::max(high, angle);
    }
    EXPECT_LT(high - low, pi);
  });
  EXPECT_GT(excluded, 100);
  EXPECT_GT(kept, 10);
}

TEST_F(EnclosureTest, no_value_exceeds_the_greatest) {
  for_each_cell(evaluator, 4, [&](const Cell& cell) {
    Enclosure enclosure;
    enclosure.set(cell, field.liftings);
    for (const Vec2 lambda : lambdas())
      EXPECT_LE(norm(evaluator.sample(cell.elem, cell.xi_at(lambda)).value), enclosure.greatest_value() + 1e-13);
  });
}

TEST_F(EnclosureTest, contraction_bounds_the_jacobian_wherever_a_cell_is_isolated) {
  int isolated = 0;
  for_each_cell(evaluator, 8, [&](const Cell& cell) {
    Enclosure enclosure;
    enclosure.set(cell, field.liftings);
    Mat2 inverse_jacobian;
    double contraction = 0;
    if (!enclosure.isolates(inverse_jacobian, contraction)) return;
    ++isolated;
    const Vec2 a = cell.xi[1] - cell.xi[0], b = cell.xi[2] - cell.xi[0];
    double greatest = 0;
    for (const Vec2 lambda : lambdas()) {
      const field::FieldSample s = evaluator.sample(cell.elem, cell.xi_at(lambda));
      const Mat2 m = inverse_jacobian * (s.dv_dx * s.dx_dxi * Mat2{a.x, b.x, a.y, b.y});
      greatest = std::max(greatest, frobenius_norm({m.xx - 1, m.xy, m.yx, m.yy - 1}));
    }
    EXPECT_LE(greatest, contraction + 1e-12);
    EXPECT_LT(contraction, 1);
  });
  EXPECT_GT(isolated, 100);
}

TEST_F(EnclosureTest, cells_with_a_zero_are_never_excluded) {
  // The polynomial is shifted so that the zero stands where we want it, near the corner with the lifting too.
  for (const Vec2 zero : {Vec2{-0.99, -0.985}, Vec2{0.31, -0.2}, Vec2{0.02, -0.97}}) {
    Field shifted = field;
    Vec2 value;
    ASSERT_TRUE(evaluator.value_at(zero, value));
    for (std::size_t e = 0; e < shifted.elem_order.size(); ++e) {
      shifted.u[shifted.coef_offsets[e]] -= std::sqrt(2.0) * value.x;
      shifted.v[shifted.coef_offsets[e]] -= std::sqrt(2.0) * value.y;
    }
    const field::FieldEvaluator moved(shifted);
    Cell cell = element_cell(moved, moved.locator().find(zero).elem), first, second;
    for (int depth = 0; depth < 24; ++depth) {
      Enclosure enclosure;
      enclosure.set(cell, shifted.liftings);
      EXPECT_FALSE(enclosure.excludes_zero()) << depth;
      bisect(cell, first, second);
      const spectral::TriMap half({first.vertex(0), first.vertex(1), first.vertex(2)});
      Vec2 xi;
      half.invert(zero, xi);
      cell = mesh::outside_reference(xi) <= 0 ? first : second;
    }
  }
}

TEST(Cell, halves_cover_the_element_and_keep_its_polynomials) {
  const Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 5, wavy);
  const field::FieldEvaluator evaluator(field);
  Cell cell = element_cell(evaluator, 1), first, second;
  bisect(cell, first, second);
  EXPECT_EQ(first.xi[0], cell.xi[0]);
  for (const Cell& half : {first, second})
    for (int k = 0; k < 3; ++k) {
      const field::FieldSample s = evaluator.sample(1, half.xi[k]);
      EXPECT_NEAR(distance(half.vertex(k), s.x), 0, 1e-15);
      const int at = k == 0 ? 0 : k == 1 ? half.degree : half.num_coefs() - 1;
      EXPECT_NEAR(distance(half.value(at), s.value), 0, 1e-13);
    }
}

}  // namespace
}  // namespace quadrille::zeros
