#include "chart/element_forms.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "base/angle.hpp"
#include "surface_samples.hpp"

namespace quadrille::chart {
namespace {

constexpr int order = 6;

/// The integral of theta1 ^ theta2.
double area(const ElementTables& tables, const ElementForms& forms) {
  return tables.weights.dot(
      (forms.theta1.xi1.cwiseProduct(forms.theta2.xi2) - forms.theta1.xi2.cwiseProduct(forms.theta2.xi1)).col(0));
}

TEST(SurfaceForms, TheCoframeIsOrthonormal) {
  const SurfaceSample sample(cap());
  const SurfaceMesh mesh = sample.lifted(order);
  const SurfaceForms forms = surface_forms(mesh, sample.face.face.loop_offsets);
  double sum = 0;
  for (const ElementForms& elem : forms.elems) {
    const double own = area(element_tables(order), elem);
    EXPECT_NEAR(square(elem, elem.theta1), own, 1e-6 * own) << "|theta1| = 1";
    EXPECT_NEAR(square(elem, elem.theta2), own, 1e-6 * own);
    sum += own;
  }
  EXPECT_NEAR(sum, 2 * pi * (1 - 0.6), 1e-6) << "of the cap";
}

/// Along the rim of a cap counter-clockwise the tangent turns against the frame by the angle that is left of a full
/// turn: 2 pi minus the area, by Gauss and Bonnet the integral of the geodesic curvature, cos / sin of the polar angle.
TEST(SurfaceForms, TheConnectionTurnsByTheCurvature) {
  const SurfaceSample sample(cap());
  const std::vector<int> no_outline{0, 0, 1};  // as if the rim were a hole
  const SurfaceForms forms = surface_forms(sample.lifted(order), no_outline);
  double omega = 0, length = 0;
  for (const EdgeForms& edge : forms.hole_edges) omega += edge.omega.sum(), length += edge.length.sum();
  EXPECT_NEAR(length, 2 * pi * 0.8, 1e-9);
  EXPECT_NEAR(std::abs(omega), 2 * pi * (1 - 0.6), 1e-6) << "the area: K = 1";
}

TEST(SurfaceForms, ACylinderIsFlat) {
  const SurfaceSample sample(cylinder_patch());
  const SurfaceForms forms = surface_forms(sample.lifted(order), sample.face.face.loop_offsets);
  double sum = 0;
  for (const ElementForms& elem : forms.elems) {
    sum += area(element_tables(order), elem);
    EXPECT_LT(std::sqrt(square(elem, elem.omega)), 1e-2) << "the frame is nearly parallel";
  }
  EXPECT_NEAR(sum, 12, 1e-9);
  EXPECT_TRUE(forms.hole_edges.empty());
}

TEST(SurfaceForms, HolesHaveTheirLengthsAndATurnAlongThem) {
  const SurfaceSample sample(tube());
  const SurfaceForms forms = surface_forms(sample.lifted(order), sample.face.face.loop_offsets);
  ASSERT_EQ(forms.hole_lengths.size(), 2u);
  EXPECT_EQ(forms.hole_lengths[0], 0);
  EXPECT_NEAR(forms.hole_lengths[1], 2 * pi, 1e-9);
  double last = 0;
  for (const EdgeForms& edge : forms.hole_edges) {
    EXPECT_EQ(edge.hole, 1);
    EXPECT_GT(edge.turn[0], last);
    last = edge.turn[edge.turn.size() - 1];
  }
  EXPECT_LT(last, 2 * pi);
}

TEST(StiffnessMatrix, IsSymmetricWithConstantsAsItsKernel) {
  const SurfaceSample sample(cap());
  const SurfaceForms forms = surface_forms(sample.lifted(order), sample.face.face.loop_offsets);
  const ElementTables& tables = element_tables(order);
  const Eigen::VectorXd one =
      tables.nodes_from_modes.fullPivLu().solve(Eigen::VectorXd::Ones(tables.nodes_from_modes.rows()));
  for (const ElementForms& elem : forms.elems) {
    const Eigen::MatrixXd matrix = stiffness_matrix(tables, elem);
    EXPECT_LT((matrix - matrix.transpose()).norm(), 1e-12 * matrix.norm());
    EXPECT_LT((matrix * one).norm(), 1e-11 * matrix.norm());
  }
}

}  // namespace
}  // namespace quadrille::chart
