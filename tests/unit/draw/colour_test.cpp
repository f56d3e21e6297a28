#include "draw/colour.hpp"

#include <gtest/gtest.h>

namespace quadrille::draw {
namespace {

TEST(Colour, GreysAreGreyAndEndsAreBlackAndWhite) {
  EXPECT_EQ(oklch(0, 0, 0), "#000000");
  EXPECT_EQ(oklch(1, 0, 0), "#ffffff");
  const std::string grey = oklch(0.6, 0, 123);
  EXPECT_EQ(grey.substr(1, 2), grey.substr(3, 2));
  EXPECT_EQ(grey.substr(1, 2), grey.substr(5, 2));
}

TEST(Colour, RampHitsItsStopsAndMixesBetween) {
  const Ramp ramp{{0, "#000000"}, {0.5, "#646464"}, {1, "#ffffff"}};
  EXPECT_EQ(ramp_colour(ramp, -1), "#000000");
  EXPECT_EQ(ramp_colour(ramp, 0.25), "#323232");
  EXPECT_EQ(ramp_colour(ramp, 0.5), "#646464");
  EXPECT_EQ(ramp_colour(ramp, 2), "#ffffff");
}

TEST(Colour, NeighboursDiffer) {
  for (int i = 0; i < 50; ++i) EXPECT_NE(quiet_colour(i), quiet_colour(i + 1));
}

}  // namespace
}  // namespace quadrille::draw
