#include "trace/element_exit.hpp"

#include <gtest/gtest.h>

#include "spectral/tri_map.hpp"

namespace quadrille::trace {
namespace {

// A straight step in the reference triangle (-1, -1), (1, -1), (-1, 1).
StreamStep step(Vec2 from, Vec2 to) { return {0, 0, 1, 1, {from, to - from, {}, {}, {}}}; }

TEST(ElementExit, AStepInsideHasNone) { EXPECT_EQ(first_exit(step({-0.5, -0.5}, {-0.4, -0.6})).edge, -1); }

TEST(ElementExit, NamesTheEdgeAndTheFractionOfTheStep) {
  const ElementExit lower = first_exit(step({-0.5, -0.75}, {-0.5, -1.25}));
  EXPECT_EQ(lower.edge, 0);
  EXPECT_NEAR(lower.fraction, 0.5, 1e-15);
  EXPECT_EQ(first_exit(step({-0.5, -0.5}, {0.5, 0.5})).edge, 1);
  EXPECT_EQ(first_exit(step({-0.5, -0.5}, {-1.5, -0.5})).edge, 2);
}

TEST(ElementExit, OfTwoEdgesTheFirstCounts) {
  // Out of the lower edge at a third, beyond the left one at two thirds.
  const ElementExit exit = first_exit(step({-0.6, -0.9}, {-1.2, -1.2}));
  EXPECT_EQ(exit.edge, 0);
  EXPECT_NEAR(exit.fraction, 1.0 / 3, 1e-14);
}

TEST(ElementExit, RoundOffBeyondAnEdgeIsInside) {
  EXPECT_EQ(first_exit(step({-0.5, -0.9}, {0.2, -1 - 1e-12})).edge, -1);
  EXPECT_EQ(first_exit(step({-0.5, -0.9}, {0.2, -1 - 1e-11})).edge, 0);
}

TEST(ElementExit, FractionsAlongEdgesAreThoseOfTheEdgePoints) {
  for (int edge = 0; edge < 3; ++edge)
    for (const double f : {0.0, 0.25, 1.0})
      EXPECT_NEAR(fraction_along_edge(edge, spectral::tri_edge_point(edge, f)), f, 1e-15);
}

TEST(ElementExit, TheTangentMayLeaveTheElementByATwentieth) {
  const StreamState state{0, {-0.5, -0.5}, 0, {0, -1}};
  EXPECT_NEAR(length_to_exit(state, 10), 2 * (0.25 + 0.05), 1e-15);
  EXPECT_EQ(length_to_exit(state, 0.1), 0.1);
}

}  // namespace
}  // namespace quadrille::trace
