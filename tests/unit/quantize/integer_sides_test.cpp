#include "quantize/integer_sides.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"
#include "t_faces.hpp"

namespace quadrille::quantize {
namespace {

// Face 0 is left of face 1 and of face 2 above it: arcs 0 and 1 lie between them, the second one directed downwards.
const std::vector<TFace> faces{face({{{2}, {0, -2}, {3}, {4}}}), face({{{5}, {6}, {7}, {-1}}}),
                               face({{{-8}, {8}, {9}, {1}}})};
const std::vector<int> lengths{2, 3, 1, 1, 5, 4, 2, 4, 3, 4};

struct Sides : testing::Test {
  IntegerSides sides{faces, lengths};
};

TEST_F(Sides, HalfEdgesStartWhereThoseBeforeThemEnd) {
  const auto expect_at = [&](HalfEdge h, int face, int side, int offset) {
    const SidePosition& at = sides.position_of(h);
    EXPECT_EQ(at.face, face);
    EXPECT_EQ(at.side, side);
    EXPECT_EQ(at.offset, offset);
  };
  expect_at({0}, 0, 1, 0);
  expect_at({1, true}, 0, 1, 2);
  expect_at({0, true}, 1, 3, 0);
  expect_at({1}, 2, 3, 0);
}

TEST_F(Sides, ABoundaryArcHasNoFaceBehindIt) {
  EXPECT_EQ(sides.position_of({2}).face, 0);
  EXPECT_EQ(sides.position_of({2, true}).face, -1);
}

TEST_F(Sides, TotalsAreSumsOfTheLengths) {
  EXPECT_EQ(sides.total(0, 1), 5);
  EXPECT_EQ(sides.total(0, 3), 5);
  EXPECT_EQ(sides.total(0, 0), 1);
  EXPECT_EQ(sides.arc(5), 4);
}

TEST_F(Sides, APositionAtANodeBelongsToTheHalfEdgeThatEndsThere) {
  const auto at = [&](int position) { return sides.half_edge_at(0, 1, position); };
  EXPECT_EQ(at(1), (std::pair{HalfEdge{0}, 1}));
  EXPECT_EQ(at(2), (std::pair{HalfEdge{0}, 2}));
  EXPECT_EQ(at(3), (std::pair{HalfEdge{1, true}, 1}));
  EXPECT_EQ(at(5), (std::pair{HalfEdge{1, true}, 3}));
  EXPECT_THROW(at(6), Defect);
}

}  // namespace
}  // namespace quadrille::quantize
