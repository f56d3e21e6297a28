#include "chart/space_length.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <ctime>
#include <numbers>

#include "../curved_surfaces.hpp"

namespace quadrille::chart {
namespace {

TEST(SpaceLength, IsThatOfACircle) {
  const SpaceCurve arc = tests::profile_arc(1, 2, 0.3, 4);
  const SpaceLength length(arc);
  EXPECT_NEAR(length.total(), 2 * 3.7, 1e-13);
  for (const double part : {0.0, 0.2, 0.5, 0.77, 1.0}) {
    const double s = part * length.total();
    EXPECT_NEAR(length.at(length.parameter(s)), s, 1e-13);
  }
  EXPECT_EQ(length.parameter(-1), arc.begin());
  EXPECT_EQ(length.parameter(100), arc.end());
}

// Knots of 1e-8 at 1: the place between them, and the speed there, is known to 1e-8, and no halving changes that.
TEST(SpaceLength, IsThatOfShortSpansAtLargeParametersInShortTime) {
  constexpr int degree = 3, num_spans = 8;
  constexpr double span = 1e-8;
  SpaceCurve curve{degree, {}, {}, {}};
  for (int i = -degree; i <= num_spans + degree; ++i) curve.knots.push_back(1 + span * std::clamp(i, 0, num_spans));
  for (int i = 0; i < num_spans + degree; ++i) {
    curve.poles.push_back({static_cast<double>(i), i % 3 - 1.0, 0});
    curve.weights.push_back(1);
  }
  SpaceCurve same = curve;  // with knots from 0 to 8
  for (double& knot : same.knots) knot = std::round((knot - 1) / span);
  const std::clock_t begin = std::clock();
  const double total = SpaceLength(curve).total();
  EXPECT_LT(std::clock() - begin, CLOCKS_PER_SEC);
  EXPECT_NEAR(total, SpaceLength(same).total(), 1e-6);
}

}  // namespace
}  // namespace quadrille::chart
