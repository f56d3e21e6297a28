#include "base/parallel.hpp"

#include <gtest/gtest.h>

#include <atomic>
#include <stdexcept>
#include <string>
#include <vector>

namespace quadrille {
namespace {

TEST(ParallelFor, CallsEachIndexOnce) {
  for (const int n : {0, 1, 2, 255, 256, 1000}) {
    for (const int num_threads : {1, 2, 3, 16}) {
      std::vector<std::atomic<int>> calls(n);
      parallel_for(n, num_threads, [&](int i) { ++calls[i]; });
      for (int i = 0; i < n; ++i) EXPECT_EQ(calls[i], 1) << i << " of " << n << " on " << num_threads;
    }
  }
}

TEST(ParallelFor, ThrowsWhatTheLowestIndexThrew) {
  for (const int num_threads : {1, 2, 3}) {
    for (int round = 0; round < 50; ++round) {
      std::string thrown;
      try {
        parallel_for(2000, num_threads, [](int i) {
          if (i >= 700 && i % 7 == 0) throw std::runtime_error(std::to_string(i));
        });
      } catch (const std::runtime_error& error) {
        thrown = error.what();
      }
      EXPECT_EQ(thrown, "700") << num_threads;
    }
  }
}

TEST(ParallelFor, LoopsMayBeNested) {
  std::vector<std::atomic<int>> calls(12 * 12);
  parallel_for(12, 2, [&](int i) { parallel_for(12, 2, [&](int j) { ++calls[12 * i + j]; }); });
  for (const auto& count : calls) EXPECT_EQ(count, 1);
}

}  // namespace
}  // namespace quadrille
