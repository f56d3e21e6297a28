#include "outline/face_pieces.hpp"

#include <gtest/gtest.h>

#include "curve/nurbs.hpp"

namespace quadrille::outline {
namespace {

heal::Loop square(Vec2 low, double side, bool is_hole = false) {
  std::vector<Vec2> p{low, low + Vec2{side, 0}, low + Vec2{side, side}, low + Vec2{0, side}};
  if (is_hole) std::swap(p[1], p[3]);
  heal::Loop loop;
  for (size_t i = 0; i < 4; ++i) loop.push_back({curve::segment(p[i], p[(i + 1) % 4]), static_cast<int>(i), ""});
  return loop;
}

Vec2 start_of(const heal::Loop& loop) { return loop.front().curve.poles.front(); }

TEST(FacePieces, LargestPieceFirstAndEachHoleInItsOwn) {
  const auto pieces = face_pieces({square({0, 0}, 2), square({0.5, 0.5}, 0.1, true), square({2, 2}, 3),
                                   square({4, 4}, 0.2, true), square({4, 3}, 0.2, true)});
  ASSERT_EQ(pieces.size(), 2U);
  ASSERT_EQ(pieces[0].size(), 3U);
  EXPECT_EQ(start_of(pieces[0][0]), (Vec2{2, 2}));
  EXPECT_EQ(start_of(pieces[0][1]), (Vec2{4, 4}));
  EXPECT_EQ(start_of(pieces[0][2]), (Vec2{4, 3}));
  ASSERT_EQ(pieces[1].size(), 2U);
  EXPECT_EQ(start_of(pieces[1][1]), (Vec2{0.5, 0.5}));
}

TEST(FacePieces, EqualPiecesKeepTheirOrder) {
  const auto pieces = face_pieces({square({0, 0}, 1), square({1, 1}, 1 + 1e-9)});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(start_of(pieces[0][0]), (Vec2{0, 0}));
}

TEST(FacePieces, APieceInTheHoleOfAnotherIsItsOwn) {
  const auto pieces = face_pieces({square({0, 0}, 9), square({3, 3}, 3, true), square({3, 3}, 1)});
  ASSERT_EQ(pieces.size(), 2U);
  EXPECT_EQ(pieces[0].size(), 2U);
}

}  // namespace
}  // namespace quadrille::outline
