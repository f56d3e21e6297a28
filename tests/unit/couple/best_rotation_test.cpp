#include "couple/best_rotation.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::couple {
namespace {

/// Four ends at right angles, from `first` on.
std::vector<double> cross_from(double first) { return {first, first + pi / 2, first + pi, first - pi / 2}; }

double quarter(double angle) {
  const double turned = std::fmod(angle, pi / 2);
  return turned < 0 ? turned + pi / 2 : turned;
}

TEST(BestRotation, WithoutNeighboursNothingTurns) { EXPECT_EQ(best_rotation({{cross_from(0.3), {}}}), 0); }

TEST(BestRotation, BringsEachEndToTheNearestOther) {
  EXPECT_NEAR(best_rotation({{cross_from(0.3), cross_from(0.5)}}), 0.2, 1e-12);
  EXPECT_NEAR(best_rotation({{cross_from(0.3), cross_from(0.2)}}), -0.1, 1e-12);
}

TEST(BestRotation, LoopsAreDecidedTogether) {
  EXPECT_NEAR(best_rotation({{cross_from(0), cross_from(0.1)}, {cross_from(0), cross_from(0.3)}}), 0.2, 1e-12);
}

// Two lines at equal angles from the axis x: an end on either is as good as on the other, one on the axis symmetric.
TEST(BestRotation, NeighboursThatAreSymmetricGetASymmetricTurn) {
  for (const double own : {0.0, 0.1, 0.35, 0.7, 1.2})
    for (const double half : {0.2, 0.3, 0.5}) {
      const double turn = best_rotation({{cross_from(own), {half, -half}}});
      const double end = quarter(own + turn);
      EXPECT_TRUE(std::min(end, pi / 2 - end) < 1e-9 || std::abs(end - pi / 4) < 1e-9) << own << ", " << half;
    }
}

// Five lines that are symmetric about an axis, as those of a wall that three round regions share.
TEST(BestRotation, DependsOnNothingButTheNeighbours) {
  const std::vector<double> others{pi, 0.8, -0.8, 2.1, -2.1};
  const double first = quarter(best_rotation({{cross_from(0), others}}));
  for (const double own : {0.05, 0.4, 0.8, 1.5}) {
    const double end = quarter(own + best_rotation({{cross_from(own), others}}));
    EXPECT_LT(std::min(std::abs(end - first), pi / 2 - std::abs(end - first)), 1e-9) << own;
  }
}

}  // namespace
}  // namespace quadrille::couple
