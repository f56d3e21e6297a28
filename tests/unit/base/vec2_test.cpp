#include "base/vec2.hpp"

#include <gtest/gtest.h>

namespace quadrille {

namespace {

TEST(Segments, DistanceOfAPointIsToTheFootOrToTheNearerEnd) {
  EXPECT_EQ(distance_to_segment({1, 2}, {0, 0}, {4, 0}), 2);
  EXPECT_EQ(distance_to_segment({-3, 4}, {0, 0}, {4, 0}), 5);
  EXPECT_EQ(distance_to_segment({7, -4}, {0, 0}, {4, 0}), 5);
  EXPECT_EQ(distance_to_segment({3, 4}, {0, 0}, {0, 0}), 5);
}

TEST(Segments, CrossOnlyInsideBoth) {
  EXPECT_TRUE(segments_cross({0, 0}, {2, 2}, {0, 2}, {2, 0}));
  EXPECT_FALSE(segments_cross({0, 0}, {2, 2}, {3, 0}, {5, 2}));
  EXPECT_FALSE(segments_cross({0, 0}, {2, 2}, {0, 4}, {4, 3}));
  EXPECT_FALSE(segments_cross({0, 0}, {2, 0}, {1, 0}, {1, 1}));  // they touch
}

TEST(Segments, DistanceOfTwoIsZeroWhereTheyCross) {
  EXPECT_EQ(distance_of_segments({0, 0}, {2, 2}, {0, 2}, {2, 0}), 0);
  EXPECT_EQ(distance_of_segments({0, 0}, {2, 0}, {1, 0}, {1, 1}), 0);
  EXPECT_EQ(distance_of_segments({0, 0}, {2, 0}, {1, 3}, {1, 1}), 1);
  EXPECT_EQ(distance_of_segments({1, 3}, {1, 1}, {0, 0}, {2, 0}), 1);
  EXPECT_EQ(distance_of_segments({0, 0}, {2, 0}, {5, 4}, {6, 9}), 5);
}

}  // namespace

}  // namespace quadrille
