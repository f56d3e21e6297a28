#include "export/equispaced.hpp"

#include <gtest/gtest.h>

#include <vector>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quad_map.hpp"

namespace quadrille::exports {
namespace {

TEST(Equispaced, NodesLieOnTheSamePolynomial) {
  for (const int order : {1, 2, 3, 4, 7, 10}) {
    const QuadMesh mesh = refined(hand_made::s_bend(), {1, order, 5e-7});
    const std::vector<Vec2> moved = equispaced_nodes(mesh);
    ASSERT_EQ(moved.size(), mesh.nodes.size());
    const int count = mesh.nodes_per_elem();
    for (int elem = 0; elem < mesh.num_elems(); elem += 7) {
      std::vector<Vec2> nodes;
      for (int k = 0; k < count; ++k) nodes.push_back(mesh.nodes[mesh.elem_nodes[elem * count + k]]);
      for (int j = 0; j <= order; ++j)
        for (int i = 0; i <= order; ++i) {
          const Vec2 exact = spectral::quad_position(order, nodes.data(), {-1 + 2.0 * i / order, -1 + 2.0 * j / order});
          const Vec2 got = moved[mesh.elem_nodes[elem * count + j * (order + 1) + i]];
          EXPECT_NEAR(distance(got, exact), 0, 1e-13);
        }
    }
  }
}

TEST(Equispaced, VerticesStayBitForBit) {
  const QuadMesh mesh = refined(hand_made::quarter_annulus(), {0.5, 5, 5e-7});
  const std::vector<Vec2> moved = equispaced_nodes(mesh);
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (const int corner : {0, 5, 30, 35}) {
      const int node = mesh.elem_nodes[elem * 36 + corner];
      EXPECT_EQ(moved[node], mesh.nodes[node]);
    }
}

}  // namespace
}  // namespace quadrille::exports
