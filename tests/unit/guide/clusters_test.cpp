#include "guide/clusters.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <complex>

#include "../support/square_field.hpp"
#include "base/warning_codes.hpp"
#include "guide/find_critical_points.hpp"

namespace quadrille::guide {
namespace {

using Complex = std::complex<double>;

zeros::FoundZero zero(Vec2 x, int index) {
  zeros::FoundZero result;
  result.x = x;
  result.index = index;
  return result;
}

struct ClustersTest : testing::Test {
  Field field = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2) { return Vec2{1, 0}; });
  field::FieldEvaluator evaluator{field};
  Report ignored;
};

TEST_F(ClustersTest, hang_together_through_others) {
  const std::vector<zeros::FoundZero> row{zero({0, 0}, 1), zero({0.1, 0}, -1), zero({0.2, 0}, 1), zero({0.5, 0}, 1)};
  const Clustering found = find_clusters(evaluator, row, {}, {0.1, 1e-10});
  ASSERT_EQ(found.clusters.size(), 1u);
  EXPECT_EQ(found.clusters[0].members.size(), 3u);
  EXPECT_EQ(found.clusters[0].index, 1);
  EXPECT_NEAR(distance(found.clusters[0].centre, {0.1, 0}), 0, 1e-15);
  EXPECT_NEAR(found.clusters[0].radius, 0.1, 1e-15);
  ASSERT_EQ(found.simple.size(), 1u);
  EXPECT_EQ(found.simple[0].x, (Vec2{0.5, 0}));
}

TEST_F(ClustersTest, leave_zeros_of_opposite_index_that_more_than_one_node_would_replace) {
  const auto ring = [](int n) {
    std::vector<zeros::FoundZero> zeros{zero({0, 0}, 1)};
    for (int k = 0; k < n; ++k) zeros.push_back(zero(0.39 * unit(2 * pi * k / n), -1));
    return zeros;
  };
  ASSERT_EQ(find_clusters(evaluator, ring(2), {}, {1e-3, 1e-10}).clusters.size(), 1u);
  EXPECT_EQ(find_clusters(evaluator, ring(2), {}, {1e-3, 1e-10}).clusters[0].index, -1);
  EXPECT_TRUE(find_clusters(evaluator, ring(3), {}, {1e-3, 1e-10}).clusters.empty());
}

TEST_F(ClustersTest, the_error_of_the_field_makes_a_cluster_too) {
  // z^2 - d^2: between the zeros |v| is at most d^2.
  const double d = 0.02;
  Field pair = interpolated_field(square_mesh({-1, -1}, 2, 2), 2, [&](Vec2 x) {
    const Complex w = std::pow(Complex(x.x, x.y), 2) - d * d;
    return Vec2{w.real(), w.imag()};
  });
  const std::vector<zeros::FoundZero> zeros{zero({-d, 0}, 1), zero({d, 0}, 1)};
  for (const double error : {0.1 * d * d, d * d}) {
    pair.elem_error.assign(pair.mesh.num_elems(), error);
    const field::FieldEvaluator with_error(pair);
    EXPECT_EQ(find_clusters(with_error, zeros, {}, {0, 1e-10}).clusters.size(), error < d * d ? 0u : 1u);
  }
}

TEST_F(ClustersTest, zeros_that_the_field_does_not_decide_are_one) {
  // Opposite zeros on the circle u = 0, on which |v| is at most 1e-7 between them; on their segment |u| is 0.09.
  Field pair = interpolated_field(square_mesh({-1, -1}, 2, 2), 2, [&](Vec2 x) {
    return Vec2{norm2(x) - 0.25, 1e-6 * (x.y - 0.4)};
  });
  const CriticalPoints found = find_critical_points(field::FieldEvaluator(pair), {0, 0, 1e-14}, ignored);
  ASSERT_EQ(found.critical_points.size(), 2u);
  EXPECT_TRUE(found.clusters.empty());
  for (const double error : {5e-8, 2e-7}) {
    pair.elem_error.assign(pair.mesh.num_elems(), 1e-15);
    pair.elem_error[0] = error;  // somewhere else
    Report report;
    const CriticalPoints points = find_critical_points(field::FieldEvaluator(pair), {0, 0, 1e-14}, report);
    EXPECT_EQ(points.clusters.size(), error < 1e-7 ? 0u : 1u);
    EXPECT_EQ(points.critical_points.size(), error < 1e-7 ? 2u : 0u);
    ASSERT_EQ(report.warnings().size(), points.clusters.size());
    if (points.clusters.empty()) continue;
    EXPECT_EQ(points.clusters[0].index, 0);
    EXPECT_EQ(points.index_sum, found.index_sum);
    EXPECT_EQ(report.warnings()[0].code, warning::zeros_not_decided);
    EXPECT_NE(report.warnings()[0].message.find("(-0.3, 0.4)"), std::string::npos) << report.warnings()[0].message;
  }
}

TEST_F(ClustersTest, the_centre_lies_in_the_domain) {
  // An L: the square without its upper right quarter, which contains the mean of the members.
  Field l_shape = interpolated_field(square_mesh({-1, -1}, 2, 2), 1, [](Vec2) { return Vec2{1, 0}; });
  TriMesh mesh = l_shape.mesh;
  mesh.elem2vertices.resize(6);
  mesh.elem_layer.resize(6);
  std::erase_if(mesh.boundary_edges, [](const BoundaryEdge& edge) { return edge.elem >= 6; });
  mesh.boundary_edges.push_back({4, 1, 1, 0, 1});
  mesh.boundary_edges.push_back({3, 1, 2, 0, 1});
  l_shape = interpolated_field(mesh, 1, [](Vec2) { return Vec2{1, 0}; });
  const field::FieldEvaluator in_l(l_shape);
  const std::vector<zeros::FoundZero> bend{zero({-0.05, 0.4}, 1), zero({-0.05, -0.05}, -1), zero({0.4, -0.05}, 1)};
  const Clustering found = find_clusters(in_l, bend, {}, {0.5, 1e-10});
  ASSERT_EQ(found.clusters.size(), 1u);
  EXPECT_EQ(found.clusters[0].centre, (Vec2{-0.05, -0.05}));
}

TEST_F(ClustersTest, open_cells_without_a_zero_are_none) {
  const zeros::OpenCell open{0, {0.1, 0.2}, 1e-3, {}};
  EXPECT_TRUE(find_clusters(evaluator, {}, {open}, {0.1, 1e-10}).clusters.empty());
  const Clustering found = find_clusters(evaluator, {zero({0.1, 0.2}, 1)}, {open}, {0.1, 1e-10});
  ASSERT_EQ(found.clusters.size(), 1u);
  EXPECT_EQ(found.clusters[0].index, 0);  // of the constant field, whatever the made-up zero says
  EXPECT_TRUE(found.clusters[0].member_indices.empty());
}

}  // namespace
}  // namespace quadrille::guide
