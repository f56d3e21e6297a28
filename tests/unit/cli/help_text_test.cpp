#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "../support/texts.hpp"
#include "cli/command_line.hpp"

namespace quadrille::cli {
namespace {

TEST(HelpRows, TheMeaningBeginsInColumn28) {
  EXPECT_EQ(help_rows({{"--order N", "the order"}}), "  --order N                 the order\n");
  const std::string longest(24, 'x'), longer(25, 'x');
  EXPECT_EQ(help_rows({{longest, "ends a column before"}}), "  " + longest + "  ends a column before\n");
  EXPECT_EQ(help_rows({{longer, "has a line of its own"}}),
            "  " + longer + "\n" + std::string(28, ' ') + "has a line of its own\n");
  EXPECT_EQ(help_rows({}), "");
}

/// 72 columns are left for the meaning.
TEST(HelpRows, LinesAreBrokenAtBlanks) {
  const std::string half(36, 'a'), rest(35, 'b');
  EXPECT_EQ(count(help_rows({{"-a", half + ' ' + rest}}), "\n"), 1);
  EXPECT_EQ(help_rows({{"-a", half + ' ' + rest + "b c"}}),
            "  -a                        " + half + '\n' + std::string(28, ' ') + rest + "b c\n");
  const std::string word(90, 'w');
  EXPECT_EQ(help_rows({{"-a", word}}), "  -a                        " + word + '\n') << "a word is not broken";
  EXPECT_EQ(help_rows({{"-a", "one\ntwo"}}), "  -a                        one\n" + std::string(28, ' ') + "two\n");
}

TEST(HelpText, PartsWithoutContentAreLeftOut) {
  HelpPage page;
  page.name = "tool", page.summary = "does nothing", page.synopsis = " [TRI]";
  page.examples = {"tool -o x"};
  std::string text = help_text(page);
  EXPECT_TRUE(text.starts_with("Usage: tool [OPTIONS] [TRI]\n\ntool does nothing.\n\nOPTIONS OF EVERY COMMAND\n"))
      << text;
  EXPECT_TRUE(text.ends_with("\nEXAMPLES\n  tool -o x\n")) << text;
  expect_counts(text, {{"\nINPUTS\n", 0}, {"\nOPTIONS\n", 0}, {"\nEXIT CODES\n", 1}, {"\n\n\n", 0}});
  page.description = "It is a sample.", page.inputs = {{"TRI", "triangles"}}, page.options = {{"--a", "first"}};
  text = help_text(page);
  expect_counts(text, {{"\n\nIt is a sample.\n\nINPUTS\n  TRI", 1}, {"\nOPTIONS\n  --a", 1}});
}

TEST(HelpText, LinesHaveAtMost100Columns) {
  HelpPage page;
  page.name = "tool", page.examples = {"tool"};
  for (int i = 0; i < 60; ++i) page.summary += "word ", page.description += "another ";
  std::istringstream lines(help_text(page));
  for (std::string line; std::getline(lines, line);) EXPECT_LE(line.size(), 100u) << line;
}

}  // namespace
}  // namespace quadrille::cli
