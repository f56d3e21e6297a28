#include "cli/stage_words.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cli {
namespace {

/// Options of each kind.
struct Sample {
  double size = 0.5;
  int order = 4;
  bool is_loud = false;
  std::string name = "plain", mode = "fast", file;
  std::vector<std::string> parts;

  Declare declare() {
    return [this](Options& o) {
      o.number("--size", size, 0, 10, "length", "the size");
      o.integer("--order", order, 1, 20, "the order");
      o.flag("--loud", is_loud, "be loud");
      o.text("--name", name, "NAME", "a name");
      o.choice("--mode", mode, {"fast", "slow"}, "the mode");
      o.input_file("--table", file, "FILE", "a table");
      o.texts("--part", parts, "A:B", "a part");
    };
  }
};

TEST(OptionNames, AreInTheOrderOfTheirDeclaration) {
  Sample sample;
  std::string names;
  for (const OptionName& name : option_names(sample.declare())) names += name.flag + ' ' + enum_name(name.kind) + ' ';
  EXPECT_EQ(names, "--size value --order value --loud flag --name value --mode value --table file --part values ");
}

TEST(OptionRows, AreThoseOfTheHelpOfOneCommand) {
  Sample sample;
  const std::string rows = option_rows(sample.declare());
  expect_contains(rows, "(unit: length; default: 0.5; interval: 0 to 10)");
  expect_counts(rows, {{"\n", 7}, {"--threads", 0}, {"--output", 0}});
}

TEST(SetOptions, SetsTheDeclaredVariablesAndLeavesTheOthers) {
  Sample sample;
  set_options(sample.declare(), {"--size", "2.5", "--loud", "--part", "1:2", "--part", "3:4", "--order", "6"});
  EXPECT_EQ(sample.size, 2.5);
  EXPECT_TRUE(sample.is_loud);
  EXPECT_EQ(sample.parts, (std::vector<std::string>{"1:2", "3:4"}));
  EXPECT_EQ(sample.order, 6);
  EXPECT_EQ(sample.name, "plain");
  set_options(sample.declare(), {});
  EXPECT_EQ(sample.size, 2.5);
}

TEST(SetOptions, RefusesAsACommandDoes) {
  Sample sample;
  const auto message = [&](const std::vector<std::string>& words) {
    return message_of<UsageError>([&] { set_options(sample.declare(), words); });
  };
  EXPECT_EQ(message({"--size", "11"}), "--size: 11 is outside its interval (0 to 10)");
  expect_contains(message({"--mode", "medium"}), "--mode");
  expect_contains(message({"--colour", "red"}), "--colour");
  EXPECT_NE(message({"--order"}), "");
}

}  // namespace
}  // namespace quadrille::cli
