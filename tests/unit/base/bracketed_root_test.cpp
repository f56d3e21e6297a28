#include "base/bracketed_root.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille {
namespace {

TEST(BracketedRoot, BisectionFindsTheRootOfARisingOrFallingFunction) {
  EXPECT_NEAR(bisect([](double x) { return x * x - 2; }, 0, 2), std::sqrt(2.0), 1e-15);
  EXPECT_NEAR(bisect([](double x) { return 2 - x * x; }, 0, 2), std::sqrt(2.0), 1e-15);
}

TEST(BracketedRoot, BisectionFindsAJump) {
  EXPECT_NEAR(bisect([](double x) { return x < 0.3 ? -1.0 : 1.0; }, 0, 1), 0.3, 1e-15);
}

TEST(BracketedRoot, FalsePositionNeedsFewEvaluations) {
  int count = 0;
  const auto f = [&count](double x) {
    ++count;
    return std::exp(-x) - 0.1;
  };
  EXPECT_NEAR(falling_root(f, 0, 10, 1e-13, 1e-14), std::log(10.0), 1e-11);
  EXPECT_LT(count, 25);
}

TEST(BracketedRoot, AnEndIsReturnedWhereTheSignDoesNotChange) {
  const auto f = [](double x) { return 1 - x; };
  EXPECT_EQ(falling_root(f, 0, 0.5, 1e-13, 1e-14), 0.5);
  EXPECT_EQ(falling_root(f, 2, 3, 1e-13, 1e-14), 2);
}

TEST(BracketedRoot, TheRootOnTheUnitIntervalIsExactToRoundOff) {
  for (const double root : {1e-9, 0.1, 0.5, 0.999}) {
    const auto f = [root](double x) { return (root - x) * (1 + 3 * x * x); };
    EXPECT_NEAR(falling_root_to_round_off(f), root, 2e-15);
  }
  EXPECT_EQ(falling_root_to_round_off([](double x) { return -x; }), 0);
}

}  // namespace
}  // namespace quadrille
