#include "export/vertex_stars.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "cell_masks.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

/// Stars by whether they are closed and by the number of their edges.
int count(const VertexStars& stars, bool is_closed, std::size_t edges) {
  return static_cast<int>(std::ranges::count_if(stars.stars(), [&](const VertexStar& star) {
    return star.is_closed == is_closed && star.edges.size() == edges;
  }));
}

int star_with(const VertexStars& stars, bool is_closed, std::size_t edges) {
  const auto at = std::ranges::find_if(
      stars.stars(), [&](const VertexStar& star) { return star.is_closed == is_closed && star.edges.size() == edges; });
  return static_cast<int>(at - stars.stars().begin());
}

std::vector<bool> no_lines(const VertexStars& stars) {
  return std::vector<bool>(stars.numbering().edges.size(), false);
}

TEST(VertexStars, OfASquareOfNineCells) {
  const QuadMesh mesh = mesh_of_mask({"###", "###", "###"});
  const VertexStars stars(mesh);
  EXPECT_EQ(stars.stars().size(), 16u);
  EXPECT_EQ(count(stars, false, 2), 4) << "corners";
  EXPECT_EQ(count(stars, false, 3), 8);
  EXPECT_EQ(count(stars, true, 4), 4);
  for (int edge = 0; edge < static_cast<int>(stars.numbering().edges.size()); ++edge) {
    const auto [a, b] = stars.ends(edge);
    EXPECT_TRUE(a >= 0 && b >= 0 && a != b);
    EXPECT_EQ(stars.other_end(edge, a), b);
    EXPECT_EQ(stars.other_end(edge, b), a);
  }
}

TEST(VertexStars, NeighboursAreAcrossACommonSide) {
  const VertexStars stars(two_quads());
  EXPECT_EQ(stars.across(0, 1), 4 * 1 + 3);
  EXPECT_EQ(stars.across(1, 3), 4 * 0 + 1);
  EXPECT_EQ(stars.across(0, 0), -1);
  EXPECT_EQ(stars.edge(0, 1), stars.edge(1, 3));
}

/// Two cells that touch at a corner have a star each there.
TEST(VertexStars, AVertexAtWhichTheMeshTouchesItselfHasTwo) {
  const VertexStars stars(mesh_of_mask({"##.", "#.#", "###"}));
  EXPECT_EQ(stars.stars().size(), static_cast<std::size_t>(stars.numbering().num_vertices()) + 1);
}

TEST(MissingLines, ARegularVertexNeedsNone) {
  const VertexStars stars(mesh_of_mask({"##", "##"}));
  const int inner = star_with(stars, true, 4);
  EXPECT_EQ(stars.deficit(inner, no_lines(stars)), 0);
  std::vector<bool> is_line = no_lines(stars);
  is_line[stars.stars()[inner].edges[0]] = true;
  EXPECT_EQ(stars.missing_lines(inner, is_line), std::vector<int>{stars.stars()[inner].edges[2]}) << "it goes on";
}

/// Three runs of two edges at a side of the boundary: the edge inside is left out, between lines.
TEST(MissingLines, NoTwoNeighbouringEdgesAreLeftOut) {
  const VertexStars stars(mesh_of_mask({"##.", "###", "###"}));
  const int reflex = star_with(stars, false, 4);  // five sides of a corner of 270 degrees would have three inside
  ASSERT_LT(reflex, static_cast<int>(stars.stars().size()));
  const std::vector<int>& edges = stars.stars()[reflex].edges;
  std::vector<bool> is_line = no_lines(stars);
  is_line[edges.front()] = is_line[edges.back()] = true;
  EXPECT_EQ(stars.missing_lines(reflex, is_line), std::vector<int>{edges[2]});
  EXPECT_EQ(stars.deficit(reflex, is_line), 1);
  is_line[edges[1]] = true;
  EXPECT_EQ(stars.deficit(reflex, is_line), 0);
}

TEST(StraightOn, LeadsAcrossRegularVerticesWithoutLines) {
  const VertexStars stars(mesh_of_mask({"##", "##"}));
  const int inner = star_with(stars, true, 4);
  const std::vector<int>& edges = stars.stars()[inner].edges;
  for (int k = 0; k < 4; ++k) EXPECT_EQ(stars.straight_on(inner, edges[k], no_lines(stars)), edges[(k + 2) % 4]);
  std::vector<bool> is_line = no_lines(stars);
  is_line[edges[1]] = true;
  EXPECT_EQ(stars.straight_on(inner, edges[0], is_line), -1);
  const int corner = star_with(stars, false, 2);
  EXPECT_EQ(stars.straight_on(corner, stars.stars()[corner].edges[0], no_lines(stars)), -1);
}

}  // namespace
}  // namespace quadrille::exports
