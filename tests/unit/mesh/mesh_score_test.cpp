#include "mesh/mesh_score.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

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

}  // namespace
}  // namespace quadrille::mesh
