#include "stiffness/harmonic_element.hpp"

#include <gtest/gtest.h>

#include <complex>
#include <functional>

#include "../test_meshes.hpp"
#include "base/error.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "stiffness/condensed_element.hpp"
#include "stiffness/element_matrices.hpp"

namespace quadrille::stiffness {
namespace {

using Complex = std::complex<double>;
using PlaneFunction = std::function<double(Vec2)>;

const spectral::TriMap straight(std::array<Vec2, 3>{Vec2{0.2, 0.1}, Vec2{1.5, 0.4}, Vec2{0.4, 1.3}});

spectral::TriMap curved() {
  static const TriMesh disc = disc_mesh(6, 8);
  return mesh::tri_maps(disc)[2];
}

PlaneFunction cube() {
  return [](Vec2 x) { return std::pow(Complex(x.x, x.y), 3).imag(); };
}

// Harmonic with a pole two diameters away.
PlaneFunction pole() {
  return [](Vec2 x) { return (1.0 / (Complex(x.x, x.y) - Complex(-2, -1.5))).real(); };
}

// The boundary modes of a function: its values at the vertices, and on each edge the integrals of its bubble times
// -psi_d'' = d (d - 1) psi_d / (1 - s^2).
Eigen::VectorXd boundary_modes(const spectral::TriMap& map, int order, const PlaneFunction& f) {
  Eigen::VectorXd modes = Eigen::VectorXd::Zero(spectral::num_boundary_modes(order));
  const spectral::Quadrature rule = spectral::gauss_legendre(order + 12);
  std::vector<double> values(order);
  for (int edge = 0; edge < 3; ++edge) {
    const auto at = [&](double s) { return f(map.position(spectral::tri_edge_point(edge, (1 + s) / 2))); };
    modes[edge] = at(-1);
    for (std::size_t i = 0; i < rule.points.size(); ++i) {
      const double s = rule.points[i], bubble = at(s) - (1 - s) / 2 * at(-1) - (1 + s) / 2 * at(1);
      spectral::edge_mode_values(order, s, values.data());
      for (int d = 2; d <= order; ++d)
        modes[spectral::edge_mode(order, edge, d)] +=
            rule.weights[i] * d * (d - 1) / (1 - s * s) * values[d - 2] * bubble;
    }
  }
  return modes;
}

double value(const Eigen::MatrixXd& coefs, int order, Vec2 xi) {
  Eigen::VectorXd modes(coefs.rows());
  spectral::orthogonal_values(order, xi, modes.data());
  return modes.dot(coefs.col(0));
}

double greatest_error(const spectral::TriMap& map, int order, const Eigen::MatrixXd& coefs, const PlaneFunction& f) {
  double greatest = 0;
  for (const Vec2 xi : spectral::tri_nodes(7))
    greatest = std::max(greatest, std::abs(value(coefs, order, xi) - f(map.position(xi))));
  return greatest;
}

TEST(HarmonicElement, IsExactForHarmonicPolynomials) {
  for (const int order : {3, 6, 13, 20}) {
    const CondensedElement element = *harmonic_element(straight, order);
    const Eigen::VectorXd modes = boundary_modes(straight, order, cube());
    const Eigen::VectorXd expected = condense(order, stiffness_matrix(straight, order)).schur.dense() * modes;
    EXPECT_LT((element.schur.dense() * modes - expected).norm(), 1e-12 * expected.norm()) << order;
    EXPECT_LT(greatest_error(straight, order, harmonic_coefs(straight, order, element.projection, modes), cube()),
              1e-13);
  }
}

TEST(HarmonicElement, ConvergesLikeTheEliminationOfInteriorModes) {
  for (const spectral::TriMap& map : {straight, curved()}) {
    for (const int order : {6, 10, 14}) {
      const Eigen::VectorXd modes = boundary_modes(map, order, pole());
      const CondensedElement all = condense(order, stiffness_matrix(map, order));
      const CondensedElement element = *harmonic_element(map, order);
      const double error = greatest_error(map, order, element_coefs(map, order, all, modes), pole());
      EXPECT_LT(error, std::pow(10.0, -0.4 * order - 1));  // the test tests something
      EXPECT_LT(greatest_error(map, order, harmonic_coefs(map, order, element.projection, modes), pole()), 2 * error);
      EXPECT_LT((element.schur.dense() * modes - all.schur.dense() * modes).norm(), 20 * error) << order;
    }
  }
}

TEST(HarmonicElement, OnlyConstantsHaveNoEnergy) {
  for (const spectral::TriMap& map : {straight, curved()}) {
    const int order = 9;
    const Eigen::MatrixXd schur = harmonic_element(map, order)->schur.dense();
    Eigen::VectorXd one = Eigen::VectorXd::Zero(schur.rows());
    one.head(3).setOnes();
    EXPECT_LT((schur * one).norm(), 1e-12);
    // Within a factor of the energies of the eliminated matrix, for all modes.
    const Eigen::MatrixXd all = condense(order, stiffness_matrix(map, order)).schur.dense();
    const Eigen::Index n = schur.rows() - 1;
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> eigen(schur.bottomRightCorner(n, n),
                                                                          all.bottomRightCorner(n, n));
    EXPECT_GT(eigen.eigenvalues().minCoeff(), 0.2);
    EXPECT_LT(eigen.eigenvalues().maxCoeff(), 10);
  }
}

TEST(HarmonicElement, SolutionsHaveTheGivenValuesOnTheEdges) {
  const int order = 7;
  for (const spectral::TriMap& map : {straight, curved()}) {
    Eigen::VectorXd modes(spectral::num_boundary_modes(order));
    for (int i = 0; i < modes.size(); ++i) modes[i] = 1.0 / (1 + i);
    const Eigen::MatrixXd coefs = harmonic_coefs(map, order, harmonic_element(map, order)->projection, modes);
    std::vector<double> values(order);
    for (int edge = 0; edge < 3; ++edge) {
      for (const double s : {-1.0, -0.3, 0.8}) {
        spectral::edge_mode_values(order, s, values.data());
        double expected = (1 - s) / 2 * modes[edge] + (1 + s) / 2 * modes[(edge + 1) % 3];
        for (int d = 2; d <= order; ++d) expected += values[d - 2] * modes[spectral::edge_mode(order, edge, d)];
        EXPECT_NEAR(value(coefs, order, spectral::tri_edge_point(edge, (1 + s) / 2)), expected, 1e-12);
      }
    }
  }
}

TEST(HarmonicElement, SlenderElementsAndLowOrdersAreLeftToTheElimination) {
  const spectral::TriMap slender(std::array<Vec2, 3>{Vec2{0, 0}, Vec2{1, 0}, Vec2{0.5, 0.2}});
  EXPECT_FALSE(harmonic_element(slender, 12));
  EXPECT_TRUE(condensed_element(slender, 12).interior);
  EXPECT_FALSE(harmonic_element(straight, 2));
  EXPECT_FALSE(condensed_element(straight, least_harmonic_order).interior);
  EXPECT_TRUE(condensed_element(straight, least_harmonic_order - 1).interior);
  const spectral::TriMap folded(std::array<Vec2, 3>{Vec2{0, 0}, Vec2{0, 1}, Vec2{1, 0}});
  EXPECT_THROW(condensed_element(folded, 12), ComputeError);
}

}  // namespace
}  // namespace quadrille::stiffness
