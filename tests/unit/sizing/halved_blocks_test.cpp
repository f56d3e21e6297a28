#include "sizing/halved_blocks.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <optional>

#include "../hand_made.hpp"
#include "base/angle.hpp"
#include "block/extract_blocks.hpp"

namespace quadrille::sizing {
namespace {

/// A block on the x axis from 0 to 2 whose upper side is a quarter of a circle. The whole is a block of twice the
/// height if the left and the right side are upright, else the line is one of its lines.
struct HalfBlock {
  BlockLayout layout;
  std::optional<HalvedSide> side;
  ArcParameter on_line;

  explicit HalfBlock(double right = 2, const std::string& name = "symmetry") {
    CadFace face = hand_made::face(
        {{curve::segment({0, 0}, {right, 0}), curve::segment({right, 0}, {2, 1}),
          curve::circular_arc({1, 0}, std::sqrt(2), pi / 4, 3 * pi / 4), curve::segment({0, 1}, {0, 0})}},
        3);
    hand_made::give_name(face, 0, name);
    Report report;
    layout = block::extract_blocks(hand_made::one_block(face, {{0}, {1}, {2}, {3}}), report);
    const MeasuredLayout measured = with_lines_of_whole(MeasuredLayout(layout), {"symmetry"});
    if (measured.halved_side(0)) side = *measured.halved_side(0);
    on_line = measured.parameter(0);
  }
};

TEST(HalvedBlocks, LinesMeetTheLineOfSymmetryAsInTheWhole) {
  const HalfBlock half;
  // The whole is symmetric about x = 1, too: in its middle the points of both curved sides have this x.
  for (const double u : {0.0, 0.25, 0.5, 0.8125, 1.0})
    EXPECT_NEAR(2 * half.on_line.fraction(u), 1 - std::sqrt(2) * std::cos(pi / 4 + u * half_pi), 1e-6) << u;
}

TEST(HalvedBlocks, PointsInsideAreThoseOfTheWhole) {
  const HalfBlock half;
  ASSERT_TRUE(half.side.has_value());
  // The whole is a square with two bulging sides: its map is known.
  const double t = 0.75, u = 0.3, s = half.on_line.fraction(u), angle = pi / 4 + u * half_pi;
  const double x = 1 - std::sqrt(2) * std::cos(angle), bulge = std::sqrt(2) * std::sin(angle) - 1;
  const SidePoints points{
      {Vec2{2 * s, 0}, {2, t}, {x, 1 + bulge}, {0, t}}, {Vec2{0, 0}, {2, 0}, {2, 1}, {0, 1}}, {s, t, u, t}};
  const Vec2 inside = position_in_whole(points, *half.side);
  EXPECT_NEAR(inside.x, x, 1e-6);
  EXPECT_NEAR(inside.y, t * (1 + bulge), 1e-12);
}

TEST(HalvedBlocks, OtherBlocksKeepTheirFractions) {
  EXPECT_TRUE(HalfBlock(2, "axis").on_line.is_identity());
  EXPECT_TRUE(HalfBlock(1.9).on_line.is_identity()) << "the whole has a corner at one end, and a line from there";
}

}  // namespace
}  // namespace quadrille::sizing
