#include "mesh/mesh_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <vector>

namespace quadrille::mesh {

namespace {

/// Two blocks of one unit square each, beside each other; the second one of this width.
QuadMesh two_squares(double width) {
  QuadMesh mesh;
  mesh.order = 1;
  mesh.block_names = {"a", "b"};
  mesh.elem_block = {0, 1};
  mesh.nodes = {{0, 0}, {1, 0}, {0, 1}, {1, 1}, {1 + width, 0}, {1 + width, 1}};
  mesh.elem_nodes = {0, 1, 2, 3, 1, 4, 3, 5};
  mesh.elem_scaled_jacobian = {1, 1};
  mesh.elem_jacobian_bound = {1, width};
  mesh.elem_edge_ratio = {1, 1 / width};
  mesh.is_valid = true;
  return mesh;
}

TEST(Exceeds, ByMoreThanFivePercentOrWhereNothingWouldBeExceeded) {
  EXPECT_TRUE(exceeds(1.06, 1));
  EXPECT_FALSE(exceeds(1.04, 1));
  EXPECT_FALSE(exceeds(1, 1.06));
  EXPECT_TRUE(exceeds(1e-3, 0)) << "one is allowed, the other not";
  EXPECT_FALSE(exceeds(0, 0));
  const double infinite = std::numeric_limits<double>::infinity();
  EXPECT_TRUE(exceeds(infinite, 3));
  EXPECT_FALSE(exceeds(infinite, infinite));
}

TEST(IsBetter, TheFirstValueThatDiffersDecides) {
  const MeshScore none, invalid{.unproved = 1}, far{.distance = 9}, thin{.elongation = 9}, skew{.skewness = 9},
      jump{.growth = 9};
  const std::vector<MeshScore> ascending{none, jump, skew, thin, far, invalid};
  for (std::size_t i = 0; i < ascending.size(); ++i)
    for (std::size_t k = 0; k < ascending.size(); ++k)
      EXPECT_EQ(is_better(ascending[i], ascending[k]), i < k) << i << ' ' << k;
}

TEST(IsBetter, SmallDifferencesLeaveTheDecisionToTheNextValue) {
  const MeshScore a{.skewness = 0.32, .growth = 1}, b{.skewness = 0.3, .growth = 2};
  EXPECT_TRUE(is_better(a, b));
  EXPECT_FALSE(is_better(b, a));
  const MeshScore c{.skewness = 0.4, .growth = 1};
  EXPECT_FALSE(is_better(c, b));
  EXPECT_TRUE(is_better(b, c));
}

TEST(IsBetter, OfGrowthEveryDifferenceCountsButRounding) {
  EXPECT_TRUE(is_better({.growth = 1}, {.growth = 1.001}));
  EXPECT_FALSE(is_better({.growth = 1}, {.growth = 1 + 1e-9}));
}

TEST(MeshScoreOf, NothingWithinTheLimits) {
  const MeshScore score = mesh_score(two_squares(0.5), {}, {1e-3, 2, 2});
  EXPECT_FALSE(is_better({}, score));
  EXPECT_FALSE(is_better(score, {}));
}

TEST(MeshScoreOf, TheExcessOfEachFigure) {
  QuadMesh mesh = two_squares(0.1);
  BoundaryDistance distance;
  distance.cad_to_mesh.distance = 2e-3;
  mesh.elem_jacobian_bound[0] = 0;
  const MeshScore score = mesh_score(mesh, distance, {1e-3, 5, 2});
  EXPECT_EQ(score.unproved, 1);
  EXPECT_NEAR(score.distance, std::log(2.0), 1e-12);
  EXPECT_NEAR(score.elongation, std::log(2.0), 1e-12);
  EXPECT_EQ(score.skewness, std::numeric_limits<double>::infinity());
  EXPECT_NEAR(score.growth, 2 * std::pow(std::log(5.0), 2), 1e-12) << "10 over 2, at both ends of the common edge";
}

TEST(MeshScoreOf, ElementsThatAreThinOnPurposeAreNotElongated) {
  const QuadMesh mesh = two_squares(0.1);
  EXPECT_EQ(mesh_score(mesh, {}, {1, 5, 0}, {false, true}).elongation, 0);
  EXPECT_GT(mesh_score(mesh, {}, {1, 5, 0}, {true, false}).elongation, 0);
}

TEST(MeshScoreOf, WithoutALimitNothingIsExceeded) {
  const MeshScore score = mesh_score(two_squares(1e-3), {}, {1, 0, 0});
  EXPECT_EQ(score.elongation, 0);
  EXPECT_EQ(score.growth, 0);
}

TEST(BlockSkewness, IsThatOfTheWorstElementOfEachBlock) {
  QuadMesh mesh;
  mesh.block_names = {"a", "b", "c"};
  mesh.elem_block = {0, 0, 1, 1, 2, 2};
  mesh.elem_scaled_jacobian = {0.9, 0.8, 0.7, 0.35, 0.5, 0.9};
  mesh.elem_jacobian_bound.assign(6, 0.1);
  mesh.elem_jacobian_bound[5] = 0;
  const std::vector<double> skewness = block_skewness(mesh);
  EXPECT_EQ(skewness[0], 0);
  EXPECT_NEAR(skewness[1], std::log(2.0), 1e-12);
  EXPECT_EQ(skewness[2], std::numeric_limits<double>::infinity()) << "not proved";
}

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
