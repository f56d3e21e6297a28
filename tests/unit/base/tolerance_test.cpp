#include "base/tolerance.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace quadrille {
namespace {

/// Sizes of the classes.
template <typename End>
std::vector<int> class_sizes(const std::vector<double>& values, const End& end_of) {
  std::vector<int> sizes;
  for (auto first = values.begin(); first != values.end();) {
    const auto last = end_of(first, values.end());
    sizes.push_back(static_cast<int>(last - first));
    first = last;
  }
  return sizes;
}

std::vector<int> chained(const std::vector<double>& values, double tol) {
  return class_sizes(values, [&](auto first, auto last) {
    return end_of_chained_ties(first, last, tol, [](double value) { return value; });
  });
}

std::vector<int> unchained(const std::vector<double>& values, double tol) {
  return class_sizes(values,
                     [&](auto first, auto last) { return end_of_ties(first, last, tol, [](double v) { return v; }); });
}

TEST(TieClasses, SeparateWhatDiffersByMoreThanTheTolerance) {
  EXPECT_EQ(chained({0, 1, 3}, 1), (std::vector<int>{2, 1}));
  EXPECT_EQ(unchained({0, 1, 3}, 1), (std::vector<int>{2, 1}));
  EXPECT_TRUE(chained({}, 1).empty());
}

TEST(TieClasses, AreChainedOrLimitedToTheTolerance) {
  EXPECT_EQ(chained({0, 1, 2, 3, 5}, 1), (std::vector<int>{4, 1}));
  EXPECT_EQ(unchained({0, 1, 2, 3, 5}, 1), (std::vector<int>{2, 2, 1}));
}

TEST(TieClasses, OfToleranceZeroHoldEqualValues) {
  EXPECT_EQ(chained({1, 1, 2}, 0), (std::vector<int>{2, 1}));
  EXPECT_EQ(unchained({1, 1, 2}, 0), (std::vector<int>{2, 1}));
}

}  // namespace
}  // namespace quadrille
