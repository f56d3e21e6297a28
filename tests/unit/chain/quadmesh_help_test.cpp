#include <gtest/gtest.h>

#include <sstream>

#include "../support/texts.hpp"
#include "chain/chain_options.hpp"

namespace quadrille::chain {
namespace {

TEST(QuadmeshHelp, the_page_of_all_options_has_each_of_them) {
  const std::string text = full_help_text();
  std::istringstream options(option_list());
  int num_options = 0;
  for (std::string command, flag, kind; options >> command >> flag >> kind; ++num_options)
    EXPECT_TRUE(contains(text, ' ' + flag + ' ') || contains(text, ' ' + flag + '\n')) << flag;
  EXPECT_GT(num_options, 100);
}

TEST(QuadmeshHelp, stages_come_in_the_order_of_the_chain) {
  const std::string text = full_help_text();
  std::size_t before = text.find("\nOPTIONS\n");
  for (const char* stage : {"CRITPOINTS", "SEPARATRIX", "BLOCKSPLIT", "QUADREFINE", "HEXSWEEP", "QUADEXPORT"}) {
    const std::size_t at = text.find(std::string("\nOPTIONS OF ") + stage + '\n');
    ASSERT_NE(at, std::string::npos) << stage;
    EXPECT_GT(at, before) << stage;
    before = at;
  }
  EXPECT_LT(before, text.find("\nEXIT CODES\n"));
}

TEST(QuadmeshHelp, the_short_page_fits_a_screen) { EXPECT_LE(count(help_text(), "\n"), 50); }

}  // namespace
}  // namespace quadrille::chain
