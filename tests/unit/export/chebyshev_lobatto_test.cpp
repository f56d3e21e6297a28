#include "export/chebyshev_lobatto.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace quadrille::exports {
namespace {

TEST(ChebyshevLobatto, KnownPoints) {
  EXPECT_EQ(chebyshev_lobatto_points(1), (std::vector<double>{-1, 1}));
  EXPECT_EQ(chebyshev_lobatto_points(2), (std::vector<double>{-1, 0, 1}));
  const std::vector<double> four = chebyshev_lobatto_points(4);
  ASSERT_EQ(four.size(), 5u);
  EXPECT_NEAR(four[1], -std::sqrt(0.5), 1e-15);
  EXPECT_NEAR(chebyshev_lobatto_points(3)[2], 0.5, 1e-15);
}

TEST(ChebyshevLobatto, AscendsAndReadsTheSameFromBothEnds) {
  for (int order = 1; order <= 30; ++order) {
    const std::vector<double> points = chebyshev_lobatto_points(order);
    EXPECT_EQ(points.back(), 1);
    for (int k = 0; k <= order; ++k) {
      EXPECT_EQ(points[k], -points[order - k]);
      if (k > 0) {
        EXPECT_LT(points[k - 1], points[k]);
      }
    }
  }
}

}  // namespace
}  // namespace quadrille::exports
