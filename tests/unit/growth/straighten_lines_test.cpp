#include "growth/straighten_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "layers/shift_along_rows.hpp"

namespace quadrille::growth {
namespace {

constexpr int num_columns = 120, num_rows = 20;

/// Rows between half circles of radius 1 and e^3, at equal factors of the radius. The lines start at equal angles and
/// end at those that `angle_at_end` makes of them.
template <class Angle>
VertexRows half_annulus(Angle angle_at_end) {
  VertexRows block;
  for (int row = 0; row <= num_rows; ++row) {
    const double radius = std::exp(3.0 * row / num_rows), part = (radius - 1) / (std::exp(3.0) - 1);
    block.rows.emplace_back();
    for (int i = 0; i <= num_columns; ++i) {
      const double start = M_PI * i / num_columns;
      block.rows.back().push_back(radius * unit(start + part * (angle_at_end(start) - start)));
    }
  }
  return block;
}

/// The greatest cotangent of the angle between lines and rows, which are circles.
double most_oblique(const VertexRows& block, const layers::RowShifts& shifts) {
  const auto at = [&](int row, int i) { return layers::index_cubic(block.rows[row], i + shifts[row][i]).value; };
  double most = 0;
  for (int row = 0; row < num_rows; ++row)
    for (int i = 0; i <= num_columns; ++i) {
      const double turn = std::abs(angle_of(at(row + 1, i)) - angle_of(at(row, i)));
      most = std::max(most, turn * num_rows / 3);
    }
  return most;
}

layers::RowShifts none() { return layers::RowShifts(num_rows + 1, std::vector<double>(num_columns + 1, 0)); }

TEST(StraighteningShifts, AreZeroForLinesNormalToTheRows) {
  const layers::RowShifts shifts = straightening_shifts(half_annulus([](double a) { return a; }), 1.3);
  for (const std::vector<double>& row : shifts)
    for (const double shift : row) EXPECT_NEAR(shift, 0, 1e-6);
}

TEST(StraighteningShifts, TurnLinesByEqualAnglesForEachFactorOfTheDistance) {
  const VertexRows block = half_annulus([](double a) { return a + 0.5 * std::sin(a); });
  EXPECT_GT(most_oblique(block, none()), 0.45);
  // 0.5 over three factors of e is 0.17 for each; neighbours are alike, so that smoothness hardly matters.
  EXPECT_LT(most_oblique(block, straightening_shifts(block, 1.3)), 0.25);
}

TEST(StraighteningShifts, AreThoseOfTheMirrorImage) {
  VertexRows block = half_annulus([](double a) { return a + 0.4 * std::sin(a) * std::cos(a / 2); }), mirrored = block;
  for (std::vector<Vec2>& row : mirrored.rows) {
    std::reverse(row.begin(), row.end());
    for (Vec2& x : row) x.x = -x.x;
  }
  const layers::RowShifts shifts = straightening_shifts(block, 1.3), others = straightening_shifts(mirrored, 1.3);
  for (int row = 0; row <= num_rows; ++row)
    for (int i = 0; i <= num_columns; ++i) EXPECT_NEAR(shifts[row][i], -others[row][num_columns - i], 1e-8);
}

TEST(StraighteningShifts, LeaveTheEndsOfLinesAndFixedVertices) {
  VertexRows block = half_annulus([](double a) { return a + 0.5 * std::sin(a); });
  block.fixed_first = 3, block.fixed_last = 2;
  const layers::RowShifts shifts = straightening_shifts(block, 1.3);
  for (int row = 0; row <= num_rows; ++row)
    for (int i = 0; i <= num_columns; ++i) {
      const bool is_free = row > 0 && row < num_rows && i >= 3 && i < num_columns - 1;
      EXPECT_EQ(shifts[row][i] != 0, is_free) << row << " " << i;
    }
}

// The lines gather at one end of the outer circle: neighbours differ by up to a factor of 2 there.
TEST(StraighteningShifts, KeepTheGrowthOfRowsNearTheLimit) {
  const VertexRows block = half_annulus([](double a) { return M_PI * std::pow(a / M_PI, 2); });
  const layers::RowShifts shifts = straightening_shifts(block, 1.3);
  double most = 1;
  for (int i = 1; i < num_columns; ++i) {
    const auto at = [&](int k) { return layers::index_cubic(block.rows[3], k + shifts[3][k]).value; };
    const double ratio = distance(at(i), at(i + 1)) / distance(at(i - 1), at(i));
    most = std::max({most, ratio, 1 / ratio});
  }
  EXPECT_LT(most, 1.3);
}

TEST(StraighteningShifts, OfABlockOfOneIntervalAreZero) {
  const layers::RowShifts shifts = straightening_shifts({{{{0, 0}, {1, 0}}, {{1, 1}, {2, 1}}}}, 1.3);
  EXPECT_EQ(shifts, (layers::RowShifts{{0, 0}, {0, 0}}));
}

}  // namespace
}  // namespace quadrille::growth
