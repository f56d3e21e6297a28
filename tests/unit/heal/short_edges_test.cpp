#include "heal/short_edges.hpp"

#include <gtest/gtest.h>

#include "raw_samples.hpp"

namespace quadrille::heal {
namespace {

std::vector<bool> removed(const std::vector<Vec2>& polygon, double length) {
  const RawFace raw = raw_polygon(polygon);
  return short_edges(measured(raw.wires)[0], length, JointLimit(raw.wires, 2 * length));
}

TEST(ShortEdges, AShortChamferIsRemoved) {
  const std::vector<Vec2> plate{{0, 0}, {3.99, 0}, {4, 0.01}, {4, 4}, {0, 4}};
  EXPECT_EQ(removed(plate, 0.02), (std::vector<bool>{false, true, false, false, false}));
  EXPECT_EQ(removed(plate, 0.01), std::vector<bool>(5, false));
}

TEST(ShortEdges, AChainCountsTheSumOfItsLengths) {
  const std::vector<Vec2> arc{{0, 0}, {3.99, 0}, {3.996, 0.003}, {4, 0.01}, {4, 4}, {0, 4}};
  EXPECT_EQ(removed(arc, 0.02), (std::vector<bool>{false, true, true, false, false, false}));
  EXPECT_EQ(removed(arc, 0.012), std::vector<bool>(6, false));
}

TEST(ShortEdges, AnEdgeBetweenParallelsThatCannotBeJoinedStays) {
  // A step of 0.02: the short lines beside it may move by 0.005 only.
  const std::vector<Vec2> step{{0, 0},    {4, 0},       {4, 3},    {2.1, 3}, {2.1, 4},
                               {2.05, 4}, {2.05, 3.98}, {2, 3.98}, {2, 3},   {0, 3}};
  EXPECT_EQ(removed(step, 0.02), std::vector<bool>(10, false));
}

TEST(ShortEdges, AWireIsNeverRemoved) {
  EXPECT_EQ(removed({{0, 0}, {0.01, 0}, {0, 0.01}}, 0.1), std::vector<bool>(3, false));
}

}  // namespace
}  // namespace quadrille::heal
