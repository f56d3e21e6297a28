#include "cli/command_line.hpp"

#include <gtest/gtest.h>

#include <sstream>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cli {

namespace {

TEST(NumberWithin, ReadsAllOfTheTextAndChecksTheInterval) {
  EXPECT_EQ(number_within("--size", "+2.5e-1", 0, 1), 0.25);
  EXPECT_EQ(message_of<UsageError>([] { number_within("--size", "1x", 0, 1); }), "--size: '1x' is not a number");
  EXPECT_EQ(message_of<UsageError>([] { number_within("--size", "2", 0, 1); }),
            "--size: 2 is outside its interval (0 to 1)");
  for (const char* text : {"", "+", "+-1", " 1", "nan"}) EXPECT_THROW(number_within("--size", text, -9, 9), UsageError);
}

TEST(IntegerWithin, ReadsAllOfTheTextAndChecksTheInterval) {
  EXPECT_EQ(integer_within("--order", "+7", 1, 20), 7);
  EXPECT_EQ(message_of<UsageError>([] { integer_within("--order", "2.5", 1, 20); }),
            "--order: '2.5' is not an integer");
  EXPECT_EQ(message_of<UsageError>([] { integer_within("--order", "21", 1, 20); }),
            "--order: 21 is outside its interval (1 to 20)");
  EXPECT_THROW(integer_within("--order", "99999999999", 1, 20), UsageError);
}

TEST(ThreadsOf, AreANumberOrAutomatic) {
  EXPECT_EQ(threads_of("auto"), 0);
  EXPECT_EQ(threads_of("1"), 1);
  EXPECT_EQ(threads_of("1024"), 1024);
  for (const char* text : {"0", "1025", "two", "", "1.5"}) EXPECT_THROW(threads_of(text), UsageError) << text;
}

HelpPage page() {
  HelpPage p;
  p.name = "sample";
  p.summary = "does nothing";
  p.synopsis = " [IN]";
  p.examples = {"sample -o x"};
  p.inputs = {{"IN", "what is read"}};
  p.options = {{"--order N", "the order"}, {"--a-very-long-option-name MODE", "its own line"}};
  return p;
}

TEST(HelpText, SectionsComeInTheirOrder) {
  const std::string text = help_text(page());
  EXPECT_EQ(text.rfind("Usage: sample [OPTIONS] [IN]\n\nsample does nothing.\n", 0), 0u) << text;
  std::size_t last = 0;
  for (const char* heading :
       {"\nINPUTS\n", "\nOPTIONS\n", "\nOPTIONS OF EVERY COMMAND\n", "\nEXIT CODES\n", "\nEXAMPLES\n  sample -o x\n"}) {
    const std::size_t at = text.find(heading);
    ASSERT_NE(at, std::string::npos) << heading;
    EXPECT_GT(at, last);
    last = at;
  }
}

TEST(HelpText, EveryExitCodeIsListed) {
  const std::string text = help_text(page());
  for (const char* code : {"\n  0 ", "\n  1 ", "\n  2 ", "\n  3 ", "\n  4 ", "\n  70 ", "\n  128 + n "})
    EXPECT_NE(text.find(code), std::string::npos) << code;
}

TEST(HelpText, ShortOptionsShareALineWithTheirMeaningAndLongOnesDoNot) {
  const std::string text = help_text(page());
  EXPECT_NE(text.find("\n  --order N" + std::string(17, ' ') + "the order\n"), std::string::npos) << text;
  EXPECT_NE(text.find("MODE\n" + std::string(28, ' ') + "its own line\n"), std::string::npos) << text;
}

TEST(HelpText, LongTextIsBrokenAtBlanksWithinAHundredColumns) {
  HelpPage p = page();
  for (int i = 0; i < 60; ++i) p.options[0].right += " word" + std::to_string(i);
  p.description = p.options[0].right;
  std::istringstream lines(help_text(p));
  std::string all;
  for (std::string line; std::getline(lines, line);) {
    EXPECT_LE(line.size(), 100u) << line;
    all += line + ' ';
  }
  EXPECT_NE(all.find(" word59 "), std::string::npos);
}

enum class Speed { slow, fast };
constexpr auto enum_names(Speed) { return std::to_array({"slow", "very-fast"}); }

/// A command line with an option by enum, a number and a flag.
class CommandLineTest : public testing::Test {
 protected:
  CommandLineTest() {
    line.choice("--speed", speed, "how fast");
    line.number("--max-deviation", deviation, 0, 45, "degrees", "the greatest deviation");
    line.optional_number("--scale", scale, 1, 9, "factor", "the factor");
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
  std::optional<double> scale;
  bool is_loud = false;
  std::string input;
  CommonOptions common;
  CommandLine line{HelpPage{"sample", "does nothing", "", "", {}, {}, {}, {}}};
};

TEST_F(CommandLineTest, AnEnumIsChosenByName) {
  parse({"--speed", "very-fast"});
  EXPECT_EQ(speed, Speed::fast);
  EXPECT_EQ(line.options_json(), R"({"loud":false,"max-deviation":40,"scale":null,"speed":"very-fast"})");
}

TEST_F(CommandLineTest, AnEnumIsRecordedWithItsDefault) {
  parse({});
  EXPECT_EQ(line.options_json(), R"({"loud":false,"max-deviation":40,"scale":null,"speed":"slow"})");
  const std::string help = help_text(line.page());
  EXPECT_NE(help.find("--speed slow|very-fast "), std::string::npos) << help;
  EXPECT_NE(help.find("how fast (default: slow)"), std::string::npos) << help;
}

TEST_F(CommandLineTest, AnOptionalNumberIsEmptyUnlessGiven) {
  parse({});
  EXPECT_EQ(scale, std::nullopt);
  EXPECT_NE(help_text(line.page()).find("(unit: factor; default: none; interval: 1 to 9)"), std::string::npos);
  parse({"--scale", "1"});
  EXPECT_EQ(scale, 1);
  EXPECT_EQ(error_of({"--scale", "0"}), "--scale: 0 is outside its interval (1 to 9)");
}

TEST_F(CommandLineTest, AnotherNameIsRefusedWithThoseThatAreAllowed) {
  EXPECT_EQ(error_of({"--speed", "fast"}), "--speed: 'fast' is not one of slow|very-fast");
  EXPECT_EQ(speed, Speed::slow);
}

TEST_F(CommandLineTest, ProgramsGetAListOfOptions) {
  EXPECT_EQ(line.option_list(),
            "sample --speed value\nsample --max-deviation value\nsample --scale value\nsample --loud flag\n");
}

TEST_F(CommandLineTest, WhatOnlyBeginsLikeAnOptionIsRefusedAndWhatFollowsDashesIsNone) {
  EXPECT_NE(error_of({"--max-deviations", "10"}), "");
  parse({"--", "--max-deviation"});
  EXPECT_EQ(input, "--max-deviation");
}

}  // namespace

}  // namespace quadrille::cli
