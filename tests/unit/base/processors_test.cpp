#include "base/processors.hpp"

#include <gtest/gtest.h>
#include <sched.h>

#include <filesystem>
#include <fstream>

namespace quadrille {
namespace {

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
