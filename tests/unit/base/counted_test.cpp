#include "base/counted.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(0, "block"), "0 blocks");
  EXPECT_EQ(counted(std::size_t{1}, "irregular node"), "1 irregular node");
  EXPECT_EQ(counted(2, "block"), "2 blocks");
}

}  // namespace
}  // namespace quadrille
