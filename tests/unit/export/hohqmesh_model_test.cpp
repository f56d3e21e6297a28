#include "export/hohqmesh_model.hpp"

#include <gtest/gtest.h>

#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

HohqmeshModel model_of(const QuadMesh& mesh, const Frame& frame) {
  return hohqmesh_model(mesh, frame, Materials::lost);
}

using HohqmeshQuads = TwoQuadsTest<model_of>;

TEST_F(HohqmeshQuads, CornersCountFromOneInTheOrderOfTheElements) {
  EXPECT_EQ(model.corners, (std::vector<int>{0, 2, 12, 10, 4, 14}));
  EXPECT_EQ(model.elem_corners, (std::vector<std::array<int, 4>>{{1, 2, 3, 4}, {2, 5, 6, 3}}));
}

TEST_F(HohqmeshQuads, OnlyTheSideOffItsChordIsCurved) {
  EXPECT_EQ(model.is_curved,
            (std::vector<std::array<bool, 4>>{{false, false, false, false}, {false, false, true, false}}));
  mesh.nodes[7].x += 1e-3;  // the common side
  model = model_of(mesh, plane_frame(mesh.face));
  EXPECT_TRUE(model.is_curved[0][1]);
  EXPECT_TRUE(model.is_curved[1][3]);
}

TEST_F(HohqmeshQuads, SidesHaveTheNamesOfTheirBoundaries) {
  EXPECT_EQ(model.names, (std::vector<std::string>{"wall", "in___out", "curve_3"}));
  EXPECT_EQ(model.name(0, 0), "wall");
  EXPECT_EQ(model.name(1, 1), "in___out");
  EXPECT_EQ(model.name(0, 1), "---");
  EXPECT_EQ(model.name(0, 3), "curve_3");
}

TEST_F(HohqmeshQuads, AnEdgeHasBothItsElements) {
  ASSERT_EQ(model.edges.size(), 7u);
  int num_inner = 0;
  for (const HohqmeshEdge& edge : model.edges) {
    if (edge.other_elem < 0) {
      EXPECT_GE(model.boundary[edge.elem][edge.side], 0);
      continue;
    }
    ++num_inner;
    EXPECT_EQ(edge.elem, 0);
    EXPECT_EQ(edge.side, 1);
    EXPECT_EQ(edge.other_elem, 1);
    EXPECT_EQ(edge.other_side, 3);
  }
  EXPECT_EQ(num_inner, 1);
}

TEST_F(HohqmeshQuads, LossesAreTold) {
  const auto tells = [&](const std::string& part) {
    for (const std::string& loss : model.losses)
      if (loss.find(part) != std::string::npos) return true;
    return false;
  };
  EXPECT_TRUE(tells("in & out"));  // renamed: one word
  EXPECT_EQ(model.side_files.size(), 1u);
  EXPECT_FALSE(tells("nodes inside elements"));
  mesh = two_quads_with_moved_middle();
  model = model_of(mesh, plane_frame(mesh.face));
  EXPECT_TRUE(tells("nodes inside elements are not stored"));
}

TEST_F(HohqmeshQuads, SidesRunInTheLocalCoordinatesDirection) {
  EXPECT_EQ(hohqmesh_side(mesh, 1, 0), (std::vector<int>{2, 3, 4}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 1), (std::vector<int>{4, 9, 14}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 2), (std::vector<int>{12, 13, 14}));
  EXPECT_EQ(hohqmesh_side(mesh, 1, 3), (std::vector<int>{2, 7, 12}));
}

TEST_F(HohqmeshQuads, PointsLieInTheFrame) {
  // Chebyshev-Lobatto points of order 2 are those of Gauss, Lobatto and Legendre.
  model = model_of(mesh, upright_frame());
  for (int n = 0; n < 15; ++n) {
    const std::array<double, 3> expected = upright_frame().at(mesh.nodes[n]);
    for (int axis = 0; axis < 3; ++axis) EXPECT_NEAR(model.points[n][axis], expected[axis], 1e-15);
  }
}

}  // namespace
}  // namespace quadrille::exports
