#include "export/split_elements.hpp"

#include <gtest/gtest.h>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "export/edge_numbering.hpp"
#include "spectral/quad_map.hpp"
#include "two_quads.hpp"

namespace quadrille::exports {
namespace {

std::vector<Vec2> own_nodes(const QuadMesh& mesh, int elem) {
  std::vector<Vec2> nodes;
  for (int k = 0; k < mesh.nodes_per_elem(); ++k)
    nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * mesh.nodes_per_elem() + k]]);
  return nodes;
}

TEST(SplitElements, StraightPiecesHaveTheNodesOfTheMesh) {
  const QuadMesh mesh = two_quads(), pieces = split_at_nodes(mesh);
  EXPECT_EQ(pieces.order, 1);
  EXPECT_EQ(pieces.num_elems(), 8);
  EXPECT_EQ(pieces.nodes.size(), mesh.nodes.size());
  EXPECT_EQ(pieces.elem_block, (std::vector<int>{0, 0, 0, 0, 1, 1, 1, 1}));
  for (int elem = 0; elem < 8; ++elem) {
    const std::vector<Vec2> whole = own_nodes(mesh, elem / 4), part = own_nodes(pieces, elem);
    const int first = elem % 4 / 2 * 3 + elem % 2;
    EXPECT_EQ(part, (std::vector<Vec2>{whole[first], whole[first + 1], whole[first + 3], whole[first + 4]}));
  }
  ASSERT_EQ(pieces.boundary_edges.size(), 12u);
  const QuadBoundaryEdge top = pieces.boundary_edges[6];  // the first half of the second quad's top, from the right
  EXPECT_EQ((std::array<int, 3>{top.elem, top.side, top.curve}), (std::array<int, 3>{7, 2, 2}));
  EXPECT_EQ(pieces.nodes[side_start(pieces, 7, 2)], (Vec2{4, 2}));
}

TEST(SplitElements, PiecesConformAndInterpolateTheElements) {
  for (const int order : {3, 4, 7}) {
    const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.4, order});
    for (const QuadMesh& pieces : {split_at_nodes(mesh), split_to_quadratic(mesh)}) {
      const int m = pieces.order == 1 ? order : (order + 1) / 2;
      ASSERT_EQ(pieces.num_elems(), m * m * mesh.num_elems());
      const EdgeNumbering edges = number_parts(pieces);
      EXPECT_EQ(edges.num_vertices() - edges.num_edges() + pieces.num_elems(), 1);  // Euler: a disc
      EXPECT_EQ(2 * edges.num_edges() - 4 * pieces.num_elems(), static_cast<int>(pieces.boundary_edges.size()));
      if (pieces.order == 1) continue;
      for (int elem = 0; elem < pieces.num_elems(); ++elem) {
        const int piece = elem % (m * m), i = piece % m, j = piece / m;
        const Vec2 middle{(2.0 * i + 1) / m - 1, (2.0 * j + 1) / m - 1};
        const Vec2 expected = spectral::quad_position(order, own_nodes(mesh, elem / (m * m)).data(), middle);
        EXPECT_LT(distance(own_nodes(pieces, elem)[4], expected), 1e-14);
      }
    }
  }
}

TEST(SplitElements, QuadraticElementsStayAsTheyAre) {
  const QuadMesh mesh = two_quads(), pieces = split_to_quadratic(mesh);
  ASSERT_EQ(pieces.num_elems(), 2);
  for (const int elem : {0, 1}) EXPECT_EQ(own_nodes(pieces, elem), own_nodes(mesh, elem));
  EXPECT_EQ(split_loss(mesh, pieces), "");
  EXPECT_EQ(split_to_quadratic(two_straight_quads()).order, 1);
}

TEST(SplitElements, TheLossIsTheDistanceOfTheSides) {
  // The top of the second quad is the parabola y = 2 + 0.5 (1 - t^2): half of it is off its chord by 0.125, to its
  // right angle by 0.125 / sqrt(1 + 0.5^2).
  const QuadMesh mesh = two_quads();
  EXPECT_EQ(split_loss(mesh, split_at_nodes(mesh)),
            "elements have straight lines as sides, which moves the boundary by up to 0.11 (0.022 of the diameter)");
}

TEST(SplitElements, PiecesThatAreNotConvexAreRefusedWithTheirPlace) {
  QuadMesh mesh = two_quads();
  mesh.nodes[6] = {0.2, 0.2};  // the middle of the first quad, beyond the diagonal of its first piece
  try {
    require_valid_pieces(split_at_nodes(mesh), "Cells");
    FAIL() << "accepted";
  } catch (const ComputeError& error) {
    EXPECT_STREQ(error.what(),
                 "Cells have straight sides, and one near (0.3, 0.3) would not be convex; refine the mesh");
  }
  mesh.nodes[6] = {-1, 1};
  EXPECT_THROW(require_valid_pieces(mesh, "Cells"), ComputeError);
  EXPECT_NO_THROW(require_valid_pieces(two_quads(), "Cells"));
}

}  // namespace
}  // namespace quadrille::exports
