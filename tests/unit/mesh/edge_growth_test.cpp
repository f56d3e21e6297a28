#include "mesh/edge_growth.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace quadrille::mesh {
namespace {

/// Rectangles of order 1 between these positions.
QuadMesh grid(const std::vector<double>& x, const std::vector<double>& y) {
  QuadMesh mesh;
  mesh.order = 1;
  const int width = static_cast<int>(x.size());
  for (const double b : y)
    for (const double a : x) mesh.nodes.push_back({a, b});
  for (int j = 0; j + 1 < static_cast<int>(y.size()); ++j)
    for (int i = 0; i + 1 < width; ++i) {
      const int corner = j * width + i;
      mesh.elem_nodes.insert(mesh.elem_nodes.end(), {corner, corner + 1, corner + width, corner + width + 1});
      mesh.elem_block.push_back(0);
    }
  return mesh;
}

TEST(EdgeGrowth, OfEqualElementsIsOne) { EXPECT_NEAR(edge_growth(grid({0, 1, 2}, {0, 1, 2, 3})).greatest, 1, 1e-15); }

TEST(EdgeGrowth, IsTheGreatestRatioOfConsecutiveEdgesWithItsPlace) {
  const EdgeGrowth along_x = edge_growth(grid({0, 1, 1.25, 2}, {0, 1, 2}));
  EXPECT_NEAR(along_x.greatest, 4, 1e-14);
  EXPECT_NEAR(along_x.position.x, 1, 1e-15);
  const EdgeGrowth along_y = edge_growth(grid({0, 1, 2}, {0, 0.1, 0.5, 1.1}));
  EXPECT_NEAR(along_y.greatest, 4, 1e-14);
  EXPECT_NEAR(along_y.position.y, 0.1, 1e-15);
}

TEST(EdgeGrowth, ExcessIsSummedOverAllLinesThatExceedTheLimit) {
  const QuadMesh mesh =
      grid({0, 1, 1.25, 2}, {0, 1, 2});  // ratios 4 and 3 on three lines, that in the middle beside two rows
  EXPECT_NEAR(edge_growth(mesh, 3.5).excess, 4 * std::pow(std::log(4 / 3.5), 2), 1e-13);
  EXPECT_EQ(edge_growth(mesh, 4.1).excess, 0);
}

TEST(EdgeGrowth, SidesOfOneElementAreNotCompared) {
  EXPECT_NEAR(edge_growth(grid({0, 1}, {0, 0.01})).greatest, 1, 1e-15);
  EXPECT_NEAR(edge_growth(grid({0, 1, 2}, {0, 0.01, 0.02})).greatest, 1, 1e-13);
}

}  // namespace
}  // namespace quadrille::mesh
