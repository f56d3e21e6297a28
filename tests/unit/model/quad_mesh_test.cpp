#include "model/quad_mesh.hpp"

#include <gtest/gtest.h>

#include <numeric>

namespace quadrille {
namespace {

/// Two elements of order 2; node k of element e is 9 e + k.
QuadMesh two_elements() {
  QuadMesh mesh;
  mesh.order = 2;
  mesh.elem_nodes.resize(18);
  std::iota(mesh.elem_nodes.begin(), mesh.elem_nodes.end(), 0);
  return mesh;
}

TEST(QuadSides, RunCounterClockwiseFromCornerToCorner) {
  const QuadMesh mesh = two_elements();
  EXPECT_EQ(side_nodes(mesh, 0, 0), (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(side_nodes(mesh, 0, 1), (std::vector<int>{2, 5, 8}));
  EXPECT_EQ(side_nodes(mesh, 0, 2), (std::vector<int>{8, 7, 6}));
  EXPECT_EQ(side_nodes(mesh, 1, 3), (std::vector<int>{15, 12, 9}));
}

TEST(QuadSides, StartWhereThePreviousSideEnds) {
  const QuadMesh mesh = two_elements();
  for (int elem = 0; elem < 2; ++elem)
    for (int side = 0; side < 4; ++side) {
      EXPECT_EQ(side_start(mesh, elem, (side + 1) % 4), side_node(mesh, elem, side, 2));
      EXPECT_EQ(side_start(mesh, elem, side), 9 * elem + local_side_node(2, side, 0));
    }
}

}  // namespace
}  // namespace quadrille
