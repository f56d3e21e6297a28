#include "cli/help_text.hpp"

#include <gtest/gtest.h>

#include <sstream>

namespace quadrille::cli {
namespace {

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

}  // namespace
}  // namespace quadrille::cli
