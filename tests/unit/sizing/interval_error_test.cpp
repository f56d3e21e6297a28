#include "sizing/interval_error.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "../hand_made.hpp"

namespace quadrille::sizing {
namespace {

TEST(IntervalError, FallsWithTheOrderAsTheoryHasIt) {
  const SeparatrixGraph g = hand_made::quarter_annulus();
  const curve::CurveTable table(g.face, g.splines);
  const curve::Chain arc(table, {{1, 0, half_pi}});
  // Along a circle the normal error of an even order gains one power by symmetry.
  for (const int order : {1, 2, 3, 4, 5, 6}) {
    const double ratio = interval_error(table, arc, 0, 0.4, order) / interval_error(table, arc, 0, 0.2, order);
    EXPECT_NEAR(std::log2(ratio), order % 2 == 0 ? order + 2 : order + 1, 0.15) << order;
  }
  EXPECT_LE(interval_error(table, curve::Chain(table, {{0, 0, 1}}), 0, 1, 3), 1e-15);
}

TEST(IntervalError, SeesABendThatIsShortAgainstTheInterval) {
  // A line cuts the corner between two sides off: what is farthest is the corner, though at equal fractions of the
  // length both are near each other's tangents.
  const CadFace face = hand_made::face(
      {{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 2}), curve::segment({1, 2}, {0, 0})}}, 2);
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable table(face, no_splines);
  const curve::Chain chain(table, {{0, 0, 1}, {1, 0, 2}});
  EXPECT_NEAR(interval_error(table, chain, 0, 1, 1), 2 / std::sqrt(5), 1e-12);
  // Interpolation through the corner itself leaves less, and no break inside means that nothing is cut off.
  EXPECT_LT(interval_error(table, curve::Chain(table, {{1, 0, 2}}), 0, 1, 1), 1e-15);
}

TEST(IntervalError, SeesAKinkBetweenArcs) {
  // Two arcs that meet at an angle of 1.66e-3 instead of in one tangent. The kink is farthest from the polynomial of
  // a side that passes it, which few samples at equal parameters miss.
  const double kink = 1.66e-3;
  const CadFace face =
      hand_made::face({{curve::circular_arc({0, 0}, 250, -0.5, 0),
                        curve::circular_arc({250 - 250 * std::cos(kink), 250 * std::sin(-kink)}, 250, kink, 0.5)}},
                      500);
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable table(face, no_splines);
  const curve::Chain chain(table, {{0, 0, 0.5}, {1, 0, 0.5 - kink}});
  // A side of length 143.6, of which 0.638 lie before the kink, and the distance of the kink from the polynomial
  // through five of its points, computed by another program.
  const double joint = chain.joint_fractions()[0], length = 143.6 / chain.length();
  EXPECT_NEAR(interval_error(table, chain, joint - 0.638 * length, joint + 0.362 * length, 4), 0.01255, 2e-5);
}

}  // namespace
}  // namespace quadrille::sizing
