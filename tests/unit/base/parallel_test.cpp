#include "base/parallel.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <mutex>
#include <set>
#include <stdexcept>
#include <string>
#include <thread>
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

/// The number of threads that work on a loop of n pieces on up to 4; these last a millisecond until there are two.
int threads_of_loop(int n) {
  std::mutex mutex;
  std::set<std::thread::id> threads;
  parallel_for(n, 4, [&](int) {
    bool is_alone = true;
    {
      const std::lock_guard lock(mutex);
      threads.insert(std::this_thread::get_id());
      is_alone = threads.size() < 2;
    }
    if (is_alone) std::this_thread::sleep_for(std::chrono::milliseconds(1));
  });
  return static_cast<int>(threads.size());
}

// In a process of its own, since the call holds for the rest of it.
TEST(ParallelForDeathTest, ThreadsStartOnlyAfterSomeWork) {
  const auto exit_code = [](const std::function<bool()>& is_right) { std::_Exit(is_right() ? 0 : 1); };
  EXPECT_EXIT(exit_code([] { return threads_of_loop(10000) > 1; }), testing::ExitedWithCode(0), "");
  EXPECT_EXIT(exit_code([] {
                start_threads_after(1e9);
                return threads_of_loop(100) == 1;
              }),
              testing::ExitedWithCode(0), "");
  EXPECT_EXIT(exit_code([] {
                start_threads_after(0);
                return threads_of_loop(10000) > 1;
              }),
              testing::ExitedWithCode(0), "");
  EXPECT_EXIT(exit_code([] {
                start_threads_after(0);
                std::vector<std::atomic<int>> calls(1000);
                parallel_for(1000, 3, [&](int i) { ++calls[i]; });
                return std::all_of(calls.begin(), calls.end(), [](int count) { return count == 1; });
              }),
              testing::ExitedWithCode(0), "");
}

TEST(Processors, ThoseOfTheAffinityCount) {
  cpu_set_t before, one;
  ASSERT_EQ(sched_getaffinity(0, sizeof before, &before), 0);
  EXPECT_GE(available_processors(), 1);
  EXPECT_LE(available_processors(), CPU_COUNT(&before));
  int first = 0;
  while (!CPU_ISSET(first, &before)) ++first;
  CPU_ZERO(&one);
  CPU_SET(first, &one);
  ASSERT_EQ(sched_setaffinity(0, sizeof one, &one), 0);
  EXPECT_EQ(available_processors(), 1);
  sched_setaffinity(0, sizeof before, &before);
}

TEST(Processors, TheLeastQuotaOfAGroupAndItsParentsCounts) {
  const std::filesystem::path mount = std::filesystem::path(testing::TempDir()) / "control_groups";
  std::filesystem::create_directories(mount / "a/b");
  const auto write = [&](const char* name, const char* text) {
    std::ofstream(mount / name / "cpu.max") << text << '\n';
  };
  const auto quota = [&](const char* group) { return quota_of_control_group(mount, group); };
  EXPECT_EQ(quota("/a/b"), 0);
  EXPECT_EQ(quota("/"), 0);
  EXPECT_EQ(quota(""), 0);
  write("a", "max 100000");
  EXPECT_EQ(quota("/a/b"), 0);
  write("a", "350000 100000");
  EXPECT_EQ(quota("/a"), 4);
  EXPECT_EQ(quota("/a/b"), 4);
  write("a/b", "5000 100000");
  EXPECT_EQ(quota("/a/b"), 1);
  EXPECT_EQ(quota("/a"), 4);
  write(".", "200000 100000");
  EXPECT_EQ(quota("/a"), 2);
  EXPECT_EQ(quota("/none"), 2);
  std::filesystem::remove_all(mount);
}

}  // namespace

}  // namespace quadrille
