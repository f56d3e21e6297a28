#include "spectral/modified_basis.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::spectral {

namespace {

std::vector<double> values_at(int order, Vec2 xi) {
  std::vector<double> values(num_tri_modes(order)), d1 = values, d2 = values;
  modified_gradients(order, xi, values.data(), d1.data(), d2.data());
  return values;
}

TEST(ModifiedBasis, VertexModesAreOneAtTheirVertex) {
  for (int k = 0; k < 3; ++k) {
    const std::vector<double> values = values_at(9, tri_edge_point(k, 0));
    for (std::size_t m = 0; m < values.size(); ++m) EXPECT_NEAR(values[m], m == static_cast<std::size_t>(k), 1e-15);
  }
}

TEST(ModifiedBasis, EdgeModesLiveOnTheirEdgeOnlyAndInteriorModesOnNone) {
  const int order = 8;
  for (int k = 0; k < 3; ++k) {
    const double s = 0.37;
    const std::vector<double> values = values_at(order, tri_edge_point(k, s));
    std::vector<double> trace(order - 1);
    edge_mode_values(order, 2 * s - 1, trace.data());
    for (int edge = 0; edge < 3; ++edge) {
      for (int d = 2; d <= order; ++d) {
        EXPECT_NEAR(values[edge_mode(order, edge, d)], edge == k ? trace[d - 2] : 0, 1e-14);
      }
    }
    for (int m = num_boundary_modes(order); m < num_tri_modes(order); ++m) EXPECT_NEAR(values[m], 0, 1e-14);
  }
}

TEST(ModifiedBasis, EdgeModesChangeSignByDegreeWhenWalkedBackwards) {
  std::vector<double> forward(9), backward(9);
  edge_mode_values(10, 0.3, forward.data());
  edge_mode_values(10, -0.3, backward.data());
  for (int d = 2; d <= 10; ++d) EXPECT_NEAR(backward[d - 2], (d % 2 == 0 ? 1 : -1) * forward[d - 2], 1e-15);
}

TEST(ModifiedBasis, ModesAreExactlyTheirOrthogonalExpansion) {
  for (const int order : {1, 2, 3, 7, 16}) {
    const Eigen::MatrixXd& table = modified_to_orthogonal(order);
    const Vec2 xi{-0.45, 0.15};
    const std::vector<double> modified = values_at(order, xi);
    Eigen::VectorXd orthogonal(num_tri_modes(order));
    orthogonal_values(order, xi, orthogonal.data());
    const Eigen::VectorXd expanded = table * orthogonal;
    for (int m = 0; m < num_tri_modes(order); ++m) EXPECT_NEAR(expanded[m], modified[m], 1e-12) << order;
  }
}

TEST(ModifiedBasis, ModesAreIndependent) {
  // All polynomials of the order are spanned: the square table is invertible.
  for (const int order : {1, 2, 5, 12}) {
    const Eigen::FullPivLU<Eigen::MatrixXd> lu(modified_to_orthogonal(order));
    EXPECT_EQ(lu.rank(), num_tri_modes(order));
  }
}

TEST(FactoredModes, ProductsAreTheModesAndTheirDerivatives) {
  for (const int order : {1, 2, 3, 4, 9}) {
    const FactoredModes modes = factored_modes(order, order + 2);
    const int n = num_tri_modes(order);
    std::vector<double> values(n), d1(n), d2(n);
    for (int i = 0; i < order + 2; ++i) {
      for (int j = 0; j < order + 2; ++j) {
        const double s = (1 + modes.eta1.points[i]) / 2, t = (1 - modes.eta2.points[j]) / 2;
        modified_gradients(order, {2 * s * t - 1, modes.eta2.points[j]}, values.data(), d1.data(), d2.data());
        for (int c = 0; c < modes.num_factors(); ++c) {
          for (int m = modes.first[c]; m < modes.first[c + 1]; ++m) {
            const double d_eta1 = modes.df(i, c) * modes.g(j, m), d_eta2 = modes.f(i, c) * modes.dg(j, m);
            const int mode = modes.position[m];
            EXPECT_NEAR(modes.f(i, c) * modes.g(j, m), values[mode], 1e-14) << order << ' ' << mode;
            EXPECT_NEAR(d_eta1 / t, d1[mode], 1e-12) << order << ' ' << mode;
            EXPECT_NEAR(s / t * d_eta1 + d_eta2, d2[mode], 1e-12) << order << ' ' << mode;
          }
        }
      }
    }
  }
}

TEST(FactoredModes, ContainEachModeOnce) {
  for (const int order : {1, 2, 5, 20}) {
    std::vector<int> position = factored_modes(order, 3).position;
    std::sort(position.begin(), position.end());
    ASSERT_EQ(position.size(), num_tri_modes(order));
    for (int m = 0; m < num_tri_modes(order); ++m) EXPECT_EQ(position[m], m);
  }
}

}  // namespace

}  // namespace quadrille::spectral
