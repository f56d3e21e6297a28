#include "mesh/chords.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

namespace quadrille {
namespace {

TEST(Chords, NumberedByTheirFirstArc) {
  EXPECT_EQ(arc_chords({{0, 1, 2, 3}}, 5), (std::vector<int>{0, 1, 0, 1, 2}));
  // Two blocks side by side share arc 1; the second walks it backwards.
  EXPECT_EQ(arc_chords({{0, 1, 2, 3}, {4, 5, 6, -2}}, 7), (std::vector<int>{0, 1, 0, 1, 2, 1, 2}));
}

TEST(Chords, AChordMayCrossItself) {
  EXPECT_EQ(arc_chords({{0, 1, 2, 3}, {2, 4, 1, 5}}, 6), (std::vector<int>{0, 0, 0, 0, 1, 1}));
}

}  // namespace
}  // namespace quadrille
