#include "spectral/factored_modes.hpp"

#include <gtest/gtest.h>

#include <algorithm>

#include "spectral/modified_basis.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::spectral {
namespace {

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
