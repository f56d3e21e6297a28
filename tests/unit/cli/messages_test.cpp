#include "cli/messages.hpp"

#include <fcntl.h>
#include <gtest/gtest.h>

#include <array>
#include <csignal>

namespace quadrille::cli {
namespace {

TEST(Messages, AreWrittenWhole) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  print_message("padapt: no field\n", ends[1]);
  std::array<char, 64> read_back{};
  ASSERT_EQ(read(ends[0], read_back.data(), read_back.size()), 17);
  EXPECT_STREQ(read_back.data(), "padapt: no field\n");
  close(ends[0]), close(ends[1]);
}

TEST(Messages, ThatNobodyReadsAreNoFailure) {
  std::array<int, 2> ends{};
  ASSERT_EQ(pipe(ends.data()), 0);
  close(ends[0]);
  print_message("lost\n", ends[1]);  // SIGPIPE would end this process
  close(ends[1]);
  print_message("lost\n", ends[1]);  // closed
  const int full = open("/dev/full", O_WRONLY);
  ASSERT_GE(full, 0);
  print_message("lost\n", full);
  close(full);
  sigset_t pending;
  sigpending(&pending);
  EXPECT_EQ(sigismember(&pending, SIGPIPE), 0);
}

}  // namespace
}  // namespace quadrille::cli
