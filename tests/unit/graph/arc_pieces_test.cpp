#include "graph/arc_pieces.hpp"

#include <gtest/gtest.h>

namespace quadrille::graph {
namespace {

TEST(ArcPieces, AreJoinedWhereACurveGoesOnAndCutAgain) {
  const Pieces whole = joined({{3, 0, 1}}, {{3, 1, 2}, {4, 5, 4}});
  ASSERT_EQ(whole.size(), 2u);
  EXPECT_EQ(whole[0].t1, 2);
  const Pieces back = reversed_pieces(whole);
  EXPECT_EQ(back[0].curve, 4);
  EXPECT_EQ(back[0].t0, 4);
  EXPECT_EQ(joined({{3, 0, 1}}, {{3, 1, 0}}).size(), 2u);  // there and back is not on
  const auto [before, behind] = cut(whole, {{}, {}, 1, 4.5});
  ASSERT_EQ(before.size(), 2u);
  EXPECT_EQ(before[1].t1, 4.5);
  ASSERT_EQ(behind.size(), 1u);
  EXPECT_EQ(behind[0].t0, 4.5);
}

}  // namespace
}  // namespace quadrille::graph
