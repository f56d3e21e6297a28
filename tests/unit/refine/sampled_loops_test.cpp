#include "refine/sampled_loops.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"

namespace quadrille::refine {
namespace {

TEST(SampledLoops, AreCirclesNearlyExactly) {
  const QuadMesh mesh = refined(hand_made::cut_annulus(3), {.size = 0.3, .order = 3, .geometry_tol = 1e-3});
  const SampledLoops loops(mesh);
  for (const int loop : {0, 1}) {
    const double radius = loop == 0 ? 1 : 0.5;
    EXPECT_NEAR(loops.length(loop), 2 * pi * radius, 1e-9);
    for (int k = -7; k < 20; ++k) {
      const LoopPoint at = loops.at(loop, 0.37 * k);
      EXPECT_NEAR(norm(at.position), radius, 1e-7);
      EXPECT_NEAR(norm(at.tangent), 1, 1e-4);
      EXPECT_NEAR(dot(at.tangent, at.position), 0, 1e-4);
      EXPECT_LT(distance(at.position, loops.at(loop, 0.37 * k + 2 * pi * radius).position), 1e-7) << "one turn further";
    }
  }
}

TEST(SampledLoops, CornersAreBetweenSamples) {
  const SampledLoops loops(refined(hand_made::unit_square(), {.size = 0.5, .order = 1}));
  EXPECT_NEAR(loops.length(0), 4, 1e-12);
  for (int k = 0; k < 4; ++k) {
    const Vec2 x = loops.at(0, k + 1e-6).position;
    EXPECT_LT(std::min({std::abs(x.x), std::abs(x.y), std::abs(1 - x.x), std::abs(1 - x.y)}), 1e-12);
  }
  EXPECT_LT(distance(loops.at(0, 0.25).position, {0.25, 0}), 1e-12);
}

}  // namespace
}  // namespace quadrille::refine
