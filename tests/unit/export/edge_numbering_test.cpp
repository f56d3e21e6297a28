#include "export/edge_numbering.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
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
    const EdgeNumbering n = number_parts(l);
    EXPECT_EQ(n.num_vertices() - n.num_edges() + l.num_elems(), 1);
    const QuadMesh annulus = refined(hand_made::cut_annulus(3), {0.3, order, 1e-2});
    const EdgeNumbering m = number_parts(annulus);
    EXPECT_EQ(m.num_vertices() - m.num_edges() + annulus.num_elems(), 0);
  }
}

TEST(EdgeNumbering, NumbersRiseAsALoopOverTheElementsMeetsThem) {
  const EdgeNumbering n = number_parts(refined(hand_made::l_shape(), {0.4, 3, 5e-7}));
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
  const EdgeNumbering n = number_parts(mesh);
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
  const EdgeNumbering n = number_parts(ring_of_two_quads());
  EXPECT_EQ(n.num_vertices(), 4);
  EXPECT_EQ(n.num_edges(), 6);
}

/// A patch of columns x rows quads of order 1 whose elements start at corners that `first` chooses.
template <class First>
QuadMesh patch(int columns, int rows, const First& first) {
  QuadMesh mesh;
  mesh.order = 1;
  for (int j = 0; j <= rows; ++j)
    for (int i = 0; i <= columns; ++i) mesh.nodes.push_back({1.0 * i, 1.0 * j});
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const int a = j * (columns + 1) + i;
      std::array<int, 4> corners{a, a + 1, a + columns + 2, a + columns + 1};
      std::rotate(corners.begin(), corners.begin() + first(i, j), corners.end());
      for (const int k : {0, 1, 3, 2}) mesh.elem_nodes.push_back(corners[k]);
      mesh.elem_block.push_back(0);
    }
  return mesh;
}

/// Three quads around the node of valence 3 in the middle of a triangle: every chord bends.
QuadMesh three_quads() {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.nodes = {{0, 0}, {-1, -1}, {0, -1}, {1, -1}, {0.6, 0}, {0, 1}, {-0.6, 0}};
  mesh.elem_nodes = {1, 2, 6, 0, 3, 4, 2, 0, 5, 6, 4, 0};
  mesh.elem_block = {0, 0, 0};
  return mesh;
}

/// Opposite edges are parallel, and the first corner is the start of both directions.
void expect_directed(const QuadMesh& mesh) {
  const QuadMesh turned = turned_along_chords(mesh);
  const EdgeNumbering numbering = number_directed_parts(turned);
  for (int elem = 0; elem < turned.num_elems(); ++elem)
    for (int side = 0; side < 4; ++side) {
      const int corner = numbering.elem2verts[4 * elem + side], next = numbering.elem2verts[4 * elem + (side + 1) % 4];
      const NumberedEdge& edge = numbering.edges[numbering.elem2edges[4 * elem + side]];
      EXPECT_EQ(edge.vertices[0], side < 2 ? corner : next) << elem << ' ' << side;
      EXPECT_EQ(edge.vertices[1], side < 2 ? next : corner) << elem << ' ' << side;
    }
}

TEST(ChordDirections, OppositeEdgesAreParallelAndMeetInTheFirstCorner) {
  std::mt19937 random(7);
  expect_directed(patch(5, 4, [&](int, int) { return static_cast<int>(random() % 4); }));
  expect_directed(three_quads());
  expect_directed(two_quads());
  expect_directed(ring_of_two_quads());
}

TEST(ChordDirections, NodesOfAnEdgeRunInItsDirection) {
  const QuadMesh turned = turned_along_chords(two_quads());
  const EdgeNumbering numbering = number_directed_parts(turned);
  for (const NumberedEdge& edge : numbering.edges) {
    const std::vector<int> nodes = edge_nodes(turned, edge);
    EXPECT_EQ(nodes.front(), numbering.vertices[edge.vertices[0]]);
    EXPECT_EQ(nodes.back(), numbering.vertices[edge.vertices[1]]);
  }
}

TEST(ChordDirections, SidesOnBoundariesAndInterfacesKeepTheirNodes) {
  QuadMesh mesh = patch(3, 3, [](int i, int j) { return (i + 3 * j) % 4; });
  for (int k = 0; k < 4 * mesh.num_elems(); ++k) mesh.boundary_edges.push_back({k / 4, k % 4, 0});
  mesh.interface_edges = mesh.boundary_edges;
  const QuadMesh turned = turned_along_chords(mesh);
  const auto nodes_of = [](const QuadMesh& of, const QuadBoundaryEdge& e) { return side_nodes(of, e.elem, e.side); };
  for (std::size_t k = 0; k < mesh.boundary_edges.size(); ++k) {
    EXPECT_EQ(nodes_of(turned, turned.boundary_edges[k]), nodes_of(mesh, mesh.boundary_edges[k]));
    EXPECT_EQ(nodes_of(turned, turned.interface_edges[k]), nodes_of(mesh, mesh.interface_edges[k]));
  }
}

TEST(ChordDirections, OnlyTheOrderOfNodesChanges) {
  const auto first = [](int i, int j) { return (i + 3 * j) % 4; };
  const QuadMesh mesh = patch(3, 3, first);
  const QuadMesh turned = turned_along_chords(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) {
    std::vector<int> before(&mesh.elem_nodes[4 * elem], &mesh.elem_nodes[4 * elem] + 4);
    std::vector<int> after(&turned.elem_nodes[4 * elem], &turned.elem_nodes[4 * elem] + 4);
    const auto turns_left = [&](const std::vector<int>& n) {
      return cross(turned.nodes[n[1]] - turned.nodes[n[0]], turned.nodes[n[2]] - turned.nodes[n[0]]) > 0;
    };
    EXPECT_TRUE(turns_left(after));
    std::sort(before.begin(), before.end());
    std::sort(after.begin(), after.end());
    EXPECT_EQ(before, after);
  }
}

}  // namespace

}  // namespace quadrille::exports
