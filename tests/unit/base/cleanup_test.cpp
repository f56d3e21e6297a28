#include "base/cleanup.hpp"

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>

namespace quadrille {
namespace {

namespace fs = std::filesystem;

std::string new_file(const std::string& name) {
  const std::string path = (fs::path(testing::TempDir()) / (name + std::to_string(getpid()))).string();
  std::ofstream(path) << "x";
  return path;
}

TEST(Cleanup, RemovesWhatIsRegisteredAndNothingElse) {
  const std::string a = new_file("cleanup_a"), b = new_file("cleanup_b"), c = new_file("cleanup_c");
  const int slot_a = register_temporary(a);
  const int slot_b = register_temporary(b);
  EXPECT_NE(slot_a, slot_b);
  release_temporary(slot_a);
  remove_temporaries();
  EXPECT_TRUE(fs::exists(a));
  EXPECT_FALSE(fs::exists(b));
  EXPECT_TRUE(fs::exists(c));
  fs::remove(a);
  fs::remove(c);
}

TEST(Cleanup, SlotsAreUsedAgain) {
  for (int i = 0; i < 100; ++i) {
    const int slot = register_temporary("never made");
    ASSERT_GE(slot, 0);
    release_temporary(slot);
  }
  release_temporary(-1);
}

TEST(Cleanup, TooLongPathsAreNotTruncated) { EXPECT_EQ(register_temporary(std::string(5000, 'x')), -1); }

}  // namespace
}  // namespace quadrille
