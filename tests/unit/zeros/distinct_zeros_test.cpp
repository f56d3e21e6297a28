#include "zeros/distinct_zeros.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"

namespace quadrille::zeros {
namespace {

struct DistinctZeros : testing::Test {
  Field field = interpolated_field(square_mesh({0, 0}, 1, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};

  /// A zero of the polynomial of `elem`, at x, found in a cell of radius 0.1.
  FoundZero zero(int elem, Vec2 x, int index = 1, double shift = 0) const {
    FoundZero result;
    result.elem = elem;
    result.x = x;
    result.index = index;
    result.cell_radius = 0.1;
    result.shift = shift;
    evaluator.maps()[elem].invert(x, result.xi);
    return result;
  }
};

TEST_F(DistinctZeros, KeepsOneOfThoseFoundOnBothSidesOfAnEdge) {
  const Vec2 on_diagonal{0.5, 0.5};
  const auto zeros = distinct_zeros(evaluator, {zero(0, on_diagonal), zero(1, on_diagonal + Vec2{1e-13, 0})});
  ASSERT_EQ(zeros.size(), 1u);
  EXPECT_EQ(zeros[0].elem, 0);
}

TEST_F(DistinctZeros, PrefersTheOneInsideItsOwnElement) {
  // Both lie above the diagonal, in element 1: the one of element 0 is beyond its edge.
  const auto zeros =
      distinct_zeros(evaluator, {zero(0, {0.5, 0.5 + 1e-6}, 1, 1e-6), zero(1, {0.5, 0.5 + 2e-6}, 1, 1e-6)});
  ASSERT_EQ(zeros.size(), 1u);
  EXPECT_EQ(zeros[0].elem, 1);
}

TEST_F(DistinctZeros, KeepsTwoOfOppositeIndexOrFarApart) {
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}, 1), zero(0, {0.6, 0.2}, -1)}).size(), 2u);
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}), zero(0, {0.61, 0.2})}).size(), 2u);
  EXPECT_EQ(distinct_zeros(evaluator, {zero(0, {0.6, 0.2}, 1, 2e-3), zero(0, {0.61, 0.2})}).size(), 1u);
}

TEST_F(DistinctZeros, KeepsAZeroThatFallsIntoTheGapButNoneBeyondTheMesh) {
  const auto gap = distinct_zeros(evaluator, {zero(0, {0.5, 0.5 + 1e-6})});
  EXPECT_EQ(gap.size(), 1u);
  EXPECT_TRUE(distinct_zeros(evaluator, {zero(0, {0.5, -1e-3})}).empty());
}

TEST_F(DistinctZeros, UnexplainedAreOpenCellsThatNoZeroReaches) {
  const OpenCell cell{0, {0.6, 0.2}, 1e-6, {}};
  EXPECT_EQ(cells_without_zero({cell}, {zero(0, {0.6, 0.2}, 1, 1e-7)}).size(), 1u);
  EXPECT_TRUE(cells_without_zero({cell}, {zero(0, {0.6, 0.2}, 1, 1e-6)}).empty());
  EXPECT_EQ(cells_without_zero({cell}, {}).size(), 1u);
}

}  // namespace
}  // namespace quadrille::zeros
