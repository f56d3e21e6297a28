#include "chart/space_length.hpp"

#include <gtest/gtest.h>

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

}  // namespace
}  // namespace quadrille::chart
