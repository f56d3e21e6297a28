#include "base/position_text.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(PositionText, HasSixDigits) {
  EXPECT_EQ(position_text({1.5, -2}), "(1.5, -2)");
  EXPECT_EQ(position_text({1.0 / 3, 1e-9}), "(0.333333, 1e-09)");
  EXPECT_EQ(position_text({1234567, 0}), "(1.23457e+06, 0)");
}

}  // namespace
}  // namespace quadrille
