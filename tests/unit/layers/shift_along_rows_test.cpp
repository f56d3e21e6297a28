#include "layers/shift_along_rows.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/vec2.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::layers {
namespace {

TEST(IndexCubic, IsExactForParabolasWithTheirDerivatives) {
  const auto parabola = [](double x) { return 1 + 2 * x - 0.5 * x * x; };
  std::vector<double> values;
  for (int k = 0; k < 5; ++k) values.push_back(parabola(k));
  for (const double x : {-0.5, 0.0, 0.3, 1.7, 3.9, 4.0, 4.5}) {
    EXPECT_NEAR(index_cubic(values, x).value, parabola(x), 1e-13) << x;
    EXPECT_NEAR(index_cubic(values, x).slope, 2 - x, 1e-13) << x;
    EXPECT_NEAR(index_cubic(values, x).bend, -1, 1e-12) << x;
  }
}

TEST(IndexCubic, IsLinearBetweenTwoPoints) {
  const IndexCubic<Vec2> at = index_cubic(std::vector<Vec2>{{0, 1}, {2, 5}}, 0.25);
  EXPECT_NEAR(distance(at.value, {0.5, 2}), 0, 1e-15);
  EXPECT_NEAR(distance(at.slope, {2, 4}), 0, 1e-15);
}

constexpr int order = 3, columns = 4, rows = 3, width = columns * order + 1;

/// A grid of unit squares.
std::vector<Vec2> unit_nodes() {
  const auto at = [](int k) { return k / order + (1 + spectral::gll_points(order)[k % order]) / 2; };
  std::vector<Vec2> nodes;
  for (int j = 0; j <= rows * order; ++j)
    for (int i = 0; i < width; ++i) nodes.push_back({at(i), at(j)});
  return nodes;
}

TEST(ShiftedAlongRows, NodesMoveWithTheirVerticesByIntervalsOfTheirRows) {
  RowShifts shifts(rows + 1, std::vector<double>(columns + 1, 0));
  for (const int row : {1, 2}) shifts[row][2] = 0.4;
  const std::vector<Vec2> nodes = unit_nodes(), moved = shifted_along_rows(nodes, width, order, shifts);
  const int row = order;
  for (int i = 0; i < width; ++i) {
    const Vec2 was = nodes[row * width + i];
    const double expected = was.x <= 1 || was.x >= 3 ? 0 : 0.4 * (1 - std::abs(was.x - 2));
    EXPECT_NEAR(moved[row * width + i].x - was.x, expected, 1e-13) << i;
    EXPECT_NEAR(moved[row * width + i].y, was.y, 1e-13) << i;
  }
}

TEST(ShiftedAlongRows, BetweenRowsShiftsAreSmoothAndTheFirstAndLastRowStay) {
  RowShifts shifts(rows + 1, std::vector<double>(columns + 1, 0));
  for (int row = 0; row <= rows; ++row) shifts[row][2] = 0.1 * row * (rows - row);
  const std::vector<Vec2> nodes = unit_nodes(), moved = shifted_along_rows(nodes, width, order, shifts);
  for (int j = 0; j <= rows * order; ++j) {
    const Vec2 was = nodes[j * width + 2 * order];
    EXPECT_NEAR(moved[j * width + 2 * order].x - was.x, 0.1 * was.y * (rows - was.y), 1e-13) << j;
  }
}

TEST(ShiftedAlongRows, WithoutShiftsNodesOfAnyRowsStay) {
  std::vector<Vec2> nodes = unit_nodes();
  for (Vec2& x : nodes) x = {x.x * x.x, x.y + std::sin(x.x)};
  const RowShifts none(rows + 1, std::vector<double>(columns + 1, 0));
  const std::vector<Vec2> moved = shifted_along_rows(nodes, width, order, none);
  for (std::size_t k = 0; k < nodes.size(); ++k) EXPECT_NEAR(distance(moved[k], nodes[k]), 0, 1e-13);
}

}  // namespace
}  // namespace quadrille::layers
