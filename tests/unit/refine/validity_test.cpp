#include "refine/validity.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../hand_made.hpp"
#include "../support/refined.hpp"
#include "base/error.hpp"
#include "mesh/element_sizes.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

/// Least over the elements of least over greatest det J, on a dense grid.
double sampled_ratio(const QuadMesh& mesh) {
  const int n = mesh.order + 1;
  std::vector<double> points;
  for (int i = 0; i <= 400; ++i) points.push_back(-1 + i / 200.0);
  const Eigen::MatrixXd value = spectral::interpolation_matrix(spectral::gll_points(mesh.order), points);
  const Eigen::MatrixXd slope = value * spectral::differentiation_matrix(spectral::gll_points(mesh.order));
  double least = 1;
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const std::vector<Vec2> nodes = element_nodes(mesh, e);
    Eigen::MatrixXd x(n, n), y(n, n);
    for (int k = 0; k < n * n; ++k) x.data()[k] = nodes[k].x, y.data()[k] = nodes[k].y;
    const Eigen::MatrixXd det = (slope * x * value.transpose()).cwiseProduct(value * y * slope.transpose()) -
                                (value * x * slope.transpose()).cwiseProduct(slope * y * value.transpose());
    least = std::min(least, det.minCoeff() / det.maxCoeff());
  }
  return least;
}

TEST(Validity, RatioOfABilinearElementIsThatOfItsCorners) {
  QuadMesh mesh = refined(hand_made::unit_square(), {1, 1, 5e-7});
  EXPECT_NEAR(least_jacobian_ratio(mesh), 1, 1e-12);
  mesh.nodes[mesh.elem_nodes[3]] = {2, 2};  // det J is linear: 1/4 at (0, 0), 3/4 at (1, 1), 1/2 at the others
  EXPECT_NEAR(least_jacobian_ratio(mesh), 1.0 / 3, 1e-4);
}

TEST(Validity, RatioEqualsThatOfDenseSamples) {
  for (const int order : {2, 3, 5, 8})
    for (const SeparatrixGraph& graph : {hand_made::quarter_annulus(), hand_made::s_bend(), hand_made::elbow()}) {
      const QuadMesh mesh = refined(graph, {1, order, 1e-2});
      EXPECT_NEAR(least_jacobian_ratio(mesh), sampled_ratio(mesh), 2e-4) << order;
    }
}

TEST(Validity, RatioOfAFoldedElementIsNotPositive) {
  QuadMesh mesh = refined(hand_made::unit_square(), {1, 1, 5e-7});
  mesh.nodes[mesh.elem_nodes[3]] = {0.25, 0.25};
  EXPECT_NEAR(least_jacobian_ratio(mesh), -0.5, 1e-4);  // -1/8 at (1, 1), 1/4 at (0, 0)
  std::swap(mesh.elem_nodes[0], mesh.elem_nodes[1]), std::swap(mesh.elem_nodes[2], mesh.elem_nodes[3]);
  EXPECT_LE(least_jacobian_ratio(mesh), 0);
}

TEST(Validity, TheWorstComeFirstAndEqualsByNumber) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  const int centre = mesh.elem_nodes[5 * 9 + 8];  // the corner that elements 5, 6, 9, 10 share
  mesh.nodes[centre] += Vec2{0.05, 0.05};
  measure_elements(mesh);
  const std::vector<WorstElement> worst = worst_elements(mesh, 5);
  ASSERT_EQ(worst.size(), 5u);
  // 6 and 9 are mirror images: equal but for rounding.
  const auto first = std::min_element(mesh.elem_scaled_jacobian.begin(), mesh.elem_scaled_jacobian.end());
  EXPECT_NEAR(worst[0].scaled_jacobian, *first, 1e-6);
  for (std::size_t i = 1; i < worst.size(); ++i) {
    EXPECT_LE(worst[i - 1].scaled_jacobian, worst[i].scaled_jacobian + 1e-6);
    if (std::abs(worst[i - 1].scaled_jacobian - worst[i].scaled_jacobian) < 1e-9) {
      EXPECT_LT(worst[i - 1].elem, worst[i].elem);
    }
  }
  for (const WorstElement& w : worst) EXPECT_EQ(w.bound, mesh.elem_jacobian_bound[w.elem]);
  EXPECT_EQ(worst_elements(mesh, 100).size(), 16u);
}

TEST(Validity, FiguresOfElementsWithTheSameNodesAreKept) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.25, 2, 5e-7});
  measure_elements(mesh);
  QuadMesh known = mesh, moved = mesh;
  for (double& bound : known.elem_jacobian_bound) bound = 7;
  moved.nodes[mesh.elem_nodes[5 * 9 + 8]] += Vec2{0.05, 0.05};  // of elements 5, 6, 9, 10
  QuadMesh expected = moved;
  measure_elements(expected);
  measure_elements(moved, nullptr, &known);
  for (const int e : {5, 6, 9, 10}) EXPECT_EQ(moved.elem_jacobian_bound[e], expected.elem_jacobian_bound[e]);
  for (const int e : {0, 4, 15}) EXPECT_EQ(moved.elem_jacobian_bound[e], 7);
  EXPECT_EQ(moved.elem_scaled_jacobian, expected.elem_scaled_jacobian);
}

TEST(Validity, ElementsThatAreNotProvedAreWorseThanAllOthersAndSayWhere) {
  QuadMesh mesh = refined(hand_made::unit_square(), {0.5, 1, 5e-7});
  mesh.face.origin = {10, 20};
  EXPECT_TRUE(mesh.is_valid);
  EXPECT_NO_THROW(require_valid_elements(mesh));
  mesh.nodes[mesh.elem_nodes[3]] = {0.1, 0.1};  // the corner that all share: folds the first element
  measure_elements(mesh);
  EXPECT_FALSE(mesh.is_valid);
  EXPECT_LT(mesh.least_jacobian_bound, 0);
  EXPECT_EQ(mesh.num_unproved(), 1);
  const WorstElement worst = worst_elements(mesh, 1).front();
  EXPECT_EQ(worst.elem, 0);
  EXPECT_EQ(worst.scaled_jacobian, -1);
  EXPECT_NEAR(worst.position.x, 0.1, 1e-12);
  EXPECT_NEAR(worst.position.y, 0.1, 1e-12);
  EXPECT_THROW(require_valid_elements(mesh), ComputeError);
}

TEST(Validity, ReportHoldsTheLeastAndTheWorst) {
  Report report;
  report_validity(refined(hand_made::elbow(), {0.5, 3, 5e-7}), report);
  const auto value = [&](const std::string& key) {
    const auto& all = report.entries();
    const auto at = std::find_if(all.begin(), all.end(), [&](const auto& entry) { return entry.first == key; });
    return at == all.end() ? -7 : std::get<double>(at->second);
  };
  EXPECT_GT(value("least_jacobian_bound"), 0);
  EXPECT_GT(value("least_jacobian_ratio"), 0);
  EXPECT_EQ(value("least_scaled_jacobian"), value("worst.1.scaled_jacobian"));
  EXPECT_LE(value("worst.1.scaled_jacobian"), value("worst.8.scaled_jacobian") + 1e-6);
  EXPECT_GE(value("mean_scaled_jacobian"), value("least_scaled_jacobian"));
}

TEST(RequireQuality, LimitsThatAreJustReachedHold) {
  const QuadMesh mesh = refined(hand_made::unit_square(), {1, 2, 1e-6});
  const auto measured = [&](double scale, double shear) {
    QuadMesh moved = mesh;
    for (Vec2& x : moved.nodes) x = {scale * x.x + shear * x.y, x.y};
    measure_elements(moved);
    mesh::measure_element_sizes(moved);
    return moved;
  };
  EXPECT_NO_THROW(require_quality(measured(4, 0), 0, 4));
  EXPECT_NO_THROW(require_quality(measured(4, 0), 0, 0)) << "no limit";
  EXPECT_THROW(require_quality(measured(4, 0), 0, 3.99), ComputeError);
  EXPECT_NO_THROW(require_quality(measured(1, 1), std::sqrt(0.5), 0));
  EXPECT_THROW(require_quality(measured(1, 1), 0.71, 0), ComputeError);
}

}  // namespace
}  // namespace quadrille::refine
