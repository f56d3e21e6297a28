#include "sizing/arc_parameter.hpp"

#include <gtest/gtest.h>

namespace quadrille::sizing {
namespace {

TEST(ArcParameter, IsTheIdentityByDefault) {
  const ArcParameter p;
  EXPECT_TRUE(p.is_identity());
  for (const double u : {0.0, 0.3, 1.0}) {
    EXPECT_EQ(p.fraction(u), u);
    EXPECT_EQ(p.parameter(u), u);
  }
}

TEST(ArcParameter, PassesThroughItsSamplesAndRises) {
  const ArcParameter p({0, 0.05, 0.1, 0.7, 0.75, 1});
  EXPECT_NEAR(p.fraction(0.4), 0.1, 1e-15);
  EXPECT_NEAR(p.fraction(0.6), 0.7, 1e-15);
  for (int k = 0; k < 1000; ++k) EXPECT_LT(p.fraction(k / 1000.0), p.fraction((k + 1) / 1000.0));
}

TEST(ArcParameter, InverseIsTheInverse) {
  const ArcParameter p({0, 0.2, 0.3, 0.8, 1});
  for (const double u : {0.0, 0.1, 0.25, 0.6, 0.99, 1.0}) EXPECT_NEAR(p.parameter(p.fraction(u)), u, 1e-14);
}

TEST(ArcParameter, MirroredSamplesGiveTheMirroredMap) {
  const ArcParameter p({0, 0.2, 0.3, 0.8, 1}), q({0, 0.2, 0.7, 0.8, 1});
  for (const double u : {0.1, 0.4, 0.77}) EXPECT_NEAR(p.fraction(u), 1 - q.fraction(1 - u), 1e-15);
}

}  // namespace
}  // namespace quadrille::sizing
