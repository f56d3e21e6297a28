#include "heal/touching_loops.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::heal {
namespace {

constexpr ContactTolerance tol{1e-7, 1e-9};

Loop polygon(const std::vector<Vec2>& p, int first_edge = 0) {
  Loop loop;
  for (size_t i = 0; i < p.size(); ++i)
    loop.push_back({curve::segment(p[i], p[(i + 1) % p.size()]), first_edge + static_cast<int>(i), ""});
  return loop;
}

// A plate of 4 x 4.
const Loop plate = polygon({{0, 0}, {4, 0}, {4, 4}, {0, 4}});

std::vector<int> edges_of(const Loop& loop) {
  std::vector<int> edges;
  for (const LoopCurve& c : loop) edges.push_back(c.cad_edge);
  return edges;
}

void expect_closed(const std::vector<Loop>& loops) {
  for (const Loop& loop : loops)
    for (size_t i = 0; i < loop.size(); ++i)
      EXPECT_EQ(loop[i].curve.poles.back(), loop[(i + 1) % loop.size()].curve.poles.front());
}

int num_contacts(const std::vector<Loop>& loops) {
  int count = 0;
  for (const auto& flags : contacts_at_starts(loops))
    count += static_cast<int>(std::count(flags.begin(), flags.end(), true));
  return count;
}

TEST(TouchingLoops, LoopsApartStay) {
  const std::vector<Loop> loops{plate, polygon({{1, 1}, {1, 2}, {2, 1}}, 4)};
  const auto result = separated_loops(loops, tol);
  ASSERT_EQ(result.size(), 2U);
  EXPECT_EQ(edges_of(result[0]), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(edges_of(result[1]), (std::vector<int>{4, 5, 6}));
  EXPECT_EQ(num_contacts(result), 0);
}

TEST(TouchingLoops, AHoleThatTouchesTheOutlineBecomesPartOfIt) {
  // Its corner lies on the middle of edge 0, which is split.
  const auto result = separated_loops({plate, polygon({{2, 5e-10}, {1, 2}, {3, 2}}, 4)}, tol);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(edges_of(result[0]), (std::vector<int>{0, 4, 5, 6, 0, 1, 2, 3}));
  expect_closed(result);
  EXPECT_EQ(num_contacts(result), 2);
}

TEST(TouchingLoops, ACircleThatTouchesAnEdgeBecomesPartOfIt) {
  // Both start at (2, 4), in the same directions.
  Loop split = polygon({{0, 0}, {4, 0}, {4, 4}, {2, 4}, {0, 4}});
  const Loop circle{{curve::circular_arc({2, 3}, 1, half_pi, -3 * half_pi), 5, ""}};
  const auto result = separated_loops({split, circle}, tol);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(edges_of(result[0]), (std::vector<int>{0, 1, 2, 5, 3, 4}));
  expect_closed(result);
}

TEST(TouchingLoops, TwoPointsSeparateTheFace) {
  const auto result = separated_loops({plate, polygon({{2, 0}, {1, 2}, {2, 4}, {3, 2}}, 4)}, tol);
  ASSERT_EQ(result.size(), 2U);
  EXPECT_EQ(edges_of(result[0]), (std::vector<int>{0, 4, 5, 2, 3}));
  EXPECT_EQ(edges_of(result[1]), (std::vector<int>{0, 1, 2, 6, 7}));
  expect_closed(result);
  for (const Loop& part : result) EXPECT_EQ(num_contacts({part}), 0);
}

TEST(TouchingLoops, AnOutlineThatTouchesItselfIsCutThere) {
  // Two squares with a common corner, drawn as one wire that goes straight on there.
  const Loop eight = polygon({{0, 0}, {1, 0}, {1, 2}, {2, 2}, {2, 1}, {0, 1}});
  const std::vector<Vec2> corners{{0, 0}, {1, 0}, {1, 1}, {2, 1}, {2, 2}, {1, 2}, {1, 1}, {0, 1}};
  EXPECT_EQ(separated_loops({polygon(corners)}, tol).size(), 2U);
  // Edges that cross are left to the check of the boundary.
  EXPECT_EQ(separated_loops({eight}, tol).size(), 1U);
}

TEST(TouchingLoops, TheEndsOfAShortEdgeAreNoContact) {
  const auto result = separated_loops({polygon({{0, 0}, {4, 0}, {4, 5e-8}, {4, 4}, {0, 4}})}, tol);
  ASSERT_EQ(result.size(), 1U);
  EXPECT_EQ(num_contacts(result), 0);
}

TEST(TouchingLoops, EdgesUponEachOtherStay) {
  const auto result = separated_loops({plate, polygon({{1, 0}, {1, 2}, {3, 2}, {3, 0}}, 4)}, tol);
  EXPECT_EQ(result.size(), 2U);
}

TEST(TouchingLoops, EdgesUponEachOtherAreLeftOutIfAsked) {
  std::vector<CommonLine> common;
  const auto result = separated_loops({plate, polygon({{1, 0}, {1, 2}, {3, 2}, {3, 0}}, 4)}, tol, &common);
  ASSERT_EQ(result.size(), 1U) << "the hole is a notch";
  EXPECT_EQ(edges_of(result[0]), (std::vector<int>{0, 4, 5, 6, 0, 1, 2, 3}));
  expect_closed(result);
  EXPECT_EQ(num_contacts(result), 0);
  ASSERT_EQ(common.size(), 1U);
  EXPECT_EQ(common[0].edge_a, 0);
  EXPECT_EQ(common[0].edge_b, 7);
  EXPECT_EQ(common[0].start, (Vec2{1, 0}));
  EXPECT_EQ(common[0].end, (Vec2{3, 0}));
  EXPECT_DOUBLE_EQ(common[0].length, 2);
}

TEST(TouchingLoops, ALineWithoutWidthSeparatesPieces) {
  std::vector<CommonLine> common;
  const auto result =
      separated_loops({polygon({{0, 0}, {1, 0}, {2, 0}, {3, 0}, {3, 2}, {2, 0}, {1, 0}, {0, 2}})}, tol, &common);
  EXPECT_EQ(result.size(), 2U);
  expect_closed(result);
  EXPECT_EQ(common.size(), 1U);
}

TEST(TouchingLoops, AHoleThatIsTheOutlineStays) {
  std::vector<CommonLine> common;
  EXPECT_EQ(separated_loops({plate, polygon({{0, 0}, {0, 4}, {4, 4}, {4, 0}}, 4)}, tol, &common).size(), 2U);
  EXPECT_TRUE(common.empty());
}

}  // namespace
}  // namespace quadrille::heal
