#include "base/disjoint_sets.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(DisjointSets, AreAloneAtFirst) {
  DisjointSets sets(4);
  for (int i = 0; i < 4; ++i) EXPECT_EQ(sets.find(i), i);
}

TEST(DisjointSets, AreFoundByTheirLeastNumberInWhateverOrderTheyAreUnited) {
  DisjointSets sets(7);
  sets.unite(6, 4);
  sets.unite(4, 2);
  sets.unite(5, 1);
  sets.unite(6, 6);
  EXPECT_EQ(sets.find(6), 2);
  EXPECT_EQ(sets.find(4), 2);
  EXPECT_EQ(sets.find(5), 1);
  EXPECT_EQ(sets.find(3), 3);
  sets.unite(6, 5);
  for (const int i : {1, 2, 4, 5, 6}) EXPECT_EQ(sets.find(i), 1) << i;
  EXPECT_EQ(sets.find(0), 0);
}

TEST(DisjointSets, AreListedByTheirLeastNumber) {
  DisjointSets sets(5);
  sets.unite(4, 1);
  sets.unite(3, 0);
  const std::vector<std::vector<int>> expected{{0, 3}, {1, 4}, {2}};
  EXPECT_EQ(sets.sets(), expected);
}

}  // namespace
}  // namespace quadrille
