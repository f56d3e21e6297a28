#include "zeros/undecided_zeros.hpp"

#include <gtest/gtest.h>

#include "../support/square_field.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::zeros {
namespace {

using Groups = std::vector<std::vector<int>>;

/// v almost vanishes on the circle of radius 1/2 about 0, where u = 0; the zeros are at (+-0.3, 0.4). Between them
/// |v| is at most 1e-7 on the upper arc and 9e-7 on the lower one.
Vec2 bent_pair(Vec2 x) { return {norm2(x) - 0.25, 1e-6 * (x.y - 0.4)}; }

/// v is small on the line x = 0, which ends at the boundary; the zeros are at (0, +-0.3), |v| between them at most
/// 9e-8.
Vec2 straight_pair(Vec2 x) { return {x.x, 1e-6 * (x.y * x.y - 0.09)}; }

Groups groups_of(Vec2 (*value)(Vec2), double error, const RegionLimits& limits = {}) {
  const Field field = interpolated_field(square_mesh({-1, -1}, 2, 3), 2, value);
  const field::FieldEvaluator evaluator(field);
  ZeroSearch search(evaluator, {});
  for (int e = 0; e < field.mesh.num_elems(); ++e) search.search(e);
  const std::vector<FoundZero> zeros = distinct_zeros(evaluator, search.zeros());
  EXPECT_EQ(zeros.size(), 2u);
  EXPECT_EQ(zeros[0].index + zeros[1].index, 0);
  return undecided_zeros(evaluator, zeros, error, limits);
}

TEST(UndecidedZeros, are_connected_along_a_bent_region_below_the_error) {
  for (const double error : {1.2e-7, 3e-7, 1e-5}) {
    const Groups groups = groups_of(bent_pair, error);
    ASSERT_EQ(groups.size(), 2u) << error;  // found from both
    EXPECT_EQ(groups[0], (std::vector<int>{0, 1}));
    EXPECT_EQ(groups[1], groups[0]);
  }
}

TEST(UndecidedZeros, are_separate_where_the_field_exceeds_its_error_between_them) {
  for (const double error : {0.0, 1e-9, 5e-8}) EXPECT_TRUE(groups_of(bent_pair, error).empty()) << error;
}

TEST(UndecidedZeros, regions_that_reach_the_boundary_connect_nothing) {
  EXPECT_EQ(groups_of(straight_pair, 2e-7).size(), 2u);  // |y| < 0.54
  EXPECT_TRUE(groups_of(straight_pair, 2e-6).empty());   // |y| < 1.4
}

TEST(UndecidedZeros, regions_of_too_many_cells_connect_nothing) {
  RegionLimits limits;
  limits.most_cells = 10;
  EXPECT_TRUE(groups_of(bent_pair, 3e-7, limits).empty());
}

TEST(UndecidedZeros, zeros_with_a_large_jacobian_are_decided) {
  const auto value = [](Vec2 x) { return Vec2{x.x, x.y * x.y - 0.09}; };
  EXPECT_TRUE(groups_of(value, 1e-3).empty());
}

TEST(UndecidedZeros, the_greatest_error_counts_up_to_a_millionth) {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 1), 1, [](Vec2) { return Vec2{1, 0}; });
  EXPECT_EQ(undecided_below(field), 0);
  field.elem_error = {1e-9, 3e-7};
  EXPECT_EQ(undecided_below(field), 3e-7);
  field.elem_error = {1e-9, 0.2};  // of a field that was not adapted
  EXPECT_EQ(undecided_below(field), 1e-6);
}

}  // namespace
}  // namespace quadrille::zeros
