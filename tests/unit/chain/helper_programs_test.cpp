#include "chain/helper_programs.hpp"

#include <gtest/gtest.h>

#include <filesystem>

namespace quadrille::chain {
namespace {

TEST(CommandPath, is_beside_this_program_or_left_to_the_shell) {
  const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe");
  EXPECT_EQ(command_path(self.filename().string()), self.string());
  EXPECT_EQ(command_path("no-such-program"), "no-such-program");
}

TEST(CommandPath, of_scripts_is_in_the_source_tree) {
  EXPECT_TRUE(command_path("points2step").ends_with("/pipelines/points2step")) << command_path("points2step");
}

}  // namespace
}  // namespace quadrille::chain
