#include "cli/command_line.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cli {
namespace {

enum class Speed { slow, fast };
constexpr auto enum_names(Speed) { return std::to_array({"slow", "very-fast"}); }

/// A command line with an option by enum, a number and a flag.
class CommandLineTest : public testing::Test {
 protected:
  CommandLineTest() {
    line.choice("--speed", speed, "how fast");
    line.number("--max-deviation", deviation, 0, 45, "degrees", "the greatest deviation");
    line.flag("--loud", is_loud, "be loud");
    line.input("IN", input, "what is read", false);
    line.add_common(common);
  }
  void parse(std::vector<std::string> arguments) {
    arguments.insert(arguments.begin(), "sample");
    std::vector<char*> argv;
    for (std::string& argument : arguments) argv.push_back(argument.data());
    line.parse(static_cast<int>(argv.size()), argv.data());
  }
  std::string error_of(const std::vector<std::string>& arguments) {
    return message_of<UsageError>([&] { parse(arguments); });
  }

  Speed speed = Speed::slow;
  double deviation = 40;
  bool is_loud = false;
  std::string input;
  CommonOptions common;
  CommandLine line{HelpPage{"sample", "does nothing", "", "", {}, {}, {}, {}}};
};

TEST_F(CommandLineTest, AnEnumIsChosenByName) {
  parse({"--speed", "very-fast"});
  EXPECT_EQ(speed, Speed::fast);
  EXPECT_EQ(line.options_json(), R"({"loud":false,"max-deviation":40,"speed":"very-fast"})");
}

TEST_F(CommandLineTest, AnEnumIsRecordedWithItsDefault) {
  parse({});
  EXPECT_EQ(line.options_json(), R"({"loud":false,"max-deviation":40,"speed":"slow"})");
  const std::string help = help_text(line.page());
  EXPECT_NE(help.find("--speed slow|very-fast "), std::string::npos) << help;
  EXPECT_NE(help.find("how fast (default: slow)"), std::string::npos) << help;
}

TEST_F(CommandLineTest, AnotherNameIsRefusedWithThoseThatAreAllowed) {
  EXPECT_EQ(error_of({"--speed", "fast"}), "--speed: 'fast' is not one of slow|very-fast");
  EXPECT_EQ(speed, Speed::slow);
}

TEST_F(CommandLineTest, ProgramsGetAListOfOptions) {
  EXPECT_EQ(line.option_list(), "sample --speed value\nsample --max-deviation value\nsample --loud flag\n");
}

TEST_F(CommandLineTest, WhatOnlyBeginsLikeAnOptionIsRefusedAndWhatFollowsDashesIsNone) {
  EXPECT_NE(error_of({"--max-deviations", "10"}), "");
  parse({"--", "--max-deviation"});
  EXPECT_EQ(input, "--max-deviation");
}

}  // namespace
}  // namespace quadrille::cli
