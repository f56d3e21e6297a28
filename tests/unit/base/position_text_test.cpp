#include "base/position_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quadrille {
namespace {

TEST(PositionText, HasSixDigits) {
  EXPECT_EQ(position_text({1.5, -2}), "(1.5, -2)");
  EXPECT_EQ(position_text({1.0 / 3, 1e-9}), "(0.333333, 1e-09)");
  EXPECT_EQ(position_text({1234567, 0}), "(1.23457e+06, 0)");
}

TEST(PositionText, NeverHasNan) {
  for (const double bad : {std::nan(""), -std::nan(""), HUGE_VAL})
    for (const std::string& text : {position_text({bad, 1}), rounded_position_text({1, bad})}) {
      EXPECT_NE(text.find("internal error"), std::string::npos) << text;
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
      EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    }
}

}  // namespace
}  // namespace quadrille
