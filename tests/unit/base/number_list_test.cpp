#include "base/number_list.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(FiniteNumber, IsTheWholeText) {
  EXPECT_EQ(finite_number_of("-2.5e1"), -25);
  for (const char* text : {"", "1 ", "+1", "0x1", "1,2", "inf", "nan", "1e999"})
    EXPECT_FALSE(finite_number_of(text)) << text;
}

TEST(NumberList, HasFiniteNumbersAndCommasOnly) {
  EXPECT_EQ(numbers_of("1,-2.5,3e2"), (std::vector<double>{1, -2.5, 300}));
  EXPECT_EQ(numbers_of("7"), std::vector<double>{7});
  for (const char* text : {"", ",", "1,", ",1", "1 2", "1;2", "x", "inf", "nan", "1e999"})
    EXPECT_TRUE(numbers_of(text).empty()) << text;
}

}  // namespace
}  // namespace quadrille
