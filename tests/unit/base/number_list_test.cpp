#include "base/number_list.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(NumberList, HasFiniteNumbersAndCommasOnly) {
  EXPECT_EQ(numbers_of("1,-2.5,3e2"), (std::vector<double>{1, -2.5, 300}));
  EXPECT_EQ(numbers_of("7"), std::vector<double>{7});
  for (const char* text : {"", ",", "1,", ",1", "1 2", "1;2", "x", "inf", "nan", "1e999"})
    EXPECT_TRUE(numbers_of(text).empty()) << text;
}

}  // namespace
}  // namespace quadrille
