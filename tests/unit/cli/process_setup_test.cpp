#include "cli/process_setup.hpp"

#include <gtest/gtest.h>

namespace quadrille::cli {

namespace {

constexpr std::size_t mebibyte = 1 << 20;

TEST(FreeHugePages, CountsBlocksOfTwoMebibytesAndMore) {
  EXPECT_EQ(free_huge_page_bytes("Node 0, zone      DMA      1      0      0      0      2      1      1      0      "
                                 "1      1      3 \n"
                                 "Node 0, zone   Normal   4381   1024    210     84     40     22     14      9      "
                                 "6     10    100 \n"),
            (2 * 1 + 4 * 3 + 2 * 10 + 4 * 100) * mebibyte);
}

TEST(FreeHugePages, CountsNothingWhereOnlySmallBlocksAreFree) {
  EXPECT_EQ(free_huge_page_bytes("Node 0, zone   Normal   4381   1024    210     84     40     22     14      9      "
                                 "6      0      0 \n"),
            0u);
}

TEST(FreeHugePages, CountsNothingInOtherText) {
  EXPECT_EQ(free_huge_page_bytes(""), 0u);
  EXPECT_EQ(free_huge_page_bytes("Node 0, zone\nNode 0, zone Normal x 1 2 3 4 5 6 7 8 9 10\n"), 0u);
}

}  // namespace

}  // namespace quadrille::cli
