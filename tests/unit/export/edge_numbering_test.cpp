#include "export/edge_numbering.hpp"

#include <gtest/gtest.h>

#include <set>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "export/skeleton.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

TEST(EdgeNumbering, CountsObeyEuler) {
  for (const int order : {1, 2, 5}) {
    const QuadMesh l = refined(hand_made::l_shape(), {0.4, order, 5e-7});
    const EdgeNumbering n = number_edges(l);
    EXPECT_EQ(n.num_vertices() - n.num_edges() + l.num_elems(), 1);
    const QuadMesh annulus = refined(hand_made::cut_annulus(3), {0.3, order, 1e-2});
    const EdgeNumbering m = number_edges(annulus);
    EXPECT_EQ(m.num_vertices() - m.num_edges() + annulus.num_elems(), 0);
  }
}

TEST(EdgeNumbering, NumbersRiseAsALoopOverTheElementsMeetsThem) {
  const EdgeNumbering n = number_edges(refined(hand_made::l_shape(), {0.4, 3, 5e-7}));
  for (const std::vector<int>* members : {&n.elem2verts, &n.elem2edges}) {
    int next = 0;
    for (const int number : *members) {
      EXPECT_LE(number, next);
      if (number == next) ++next;
    }
    EXPECT_EQ(next, members == &n.elem2verts ? n.num_vertices() : n.num_edges());
  }
}

TEST(EdgeNumbering, EdgesRunFromTheLowerVertexThroughTheSideOfEveryElementThatHasThem) {
  const QuadMesh mesh = refined(hand_made::l_shape(), {0.4, 3, 5e-7});
  const EdgeNumbering n = number_edges(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const NumberedEdge& edge = n.edges[n.elem2edges[4 * elem + side]];
      EXPECT_LT(edge.vertices[0], edge.vertices[1]);
      const std::vector<int> nodes = edge_nodes(mesh, edge), around = side_nodes(mesh, elem, side);
      EXPECT_EQ(nodes.front(), n.vertices[edge.vertices[0]]);
      EXPECT_EQ(nodes.back(), n.vertices[edge.vertices[1]]);
      EXPECT_EQ(std::set<int>(nodes.begin(), nodes.end()), std::set<int>(around.begin(), around.end()));
    }
}

TEST(EdgeNumbering, TwoEdgesBetweenTwoVerticesStayTwo) {
  const EdgeNumbering n = number_edges(ring_of_two_quads());
  EXPECT_EQ(n.num_vertices(), 4);
  EXPECT_EQ(n.num_edges(), 6);
}

}  // namespace
}  // namespace quadrille::exports
