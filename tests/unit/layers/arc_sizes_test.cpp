#include "layers/arc_sizes.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "wall_samples.hpp"

namespace quadrille::layers {
namespace {

TEST(ArcSizes, AreTheHarmonicMeanOfTheSizeField) {
  // h(x) = 0.1 + ln(1.5) |x| on the bottom side, from a source in its beginning.
  const wall_samples::PlannedWalls p(hand_made::unit_square(), 1, {"side_0:first=0.1,layers=1"});
  const double slope = std::log(1.5);
  const sizing::SizeField sizes(10, SizeSources{{{{0, 0}, 0.1, 0}}, {}, 0}, {}, 1.5);
  const WallInput input{p.measured, p.specs, sizes, 4, 1e-3};
  ArcSizes arcs = arc_sizes(input);
  const int bottom = p.arc_between({0, 0}, {1, 0});
  EXPECT_NEAR(arcs.at(bottom), slope / std::log((0.1 + slope) / 0.1), 1e-3);
  arcs.scale[bottom] = 0.5;
  EXPECT_EQ(arcs.at(bottom), 0.5 * arcs.prescribed[bottom]);
}

}  // namespace
}  // namespace quadrille::layers
