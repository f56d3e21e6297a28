#include "cad/name_options.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::cad {
namespace {

using Kind = NameRule::Kind;

TEST(NameOptions, AListIsOneRuleForEachItem) {
  const std::vector<NameRule> rules = name_option_rules({"wall=1,3-6,edge_*,*"});
  ASSERT_EQ(rules.size(), 4);
  EXPECT_TRUE(rules[0].kind == Kind::range && rules[0].number == 1 && rules[0].last_number == 1);
  EXPECT_TRUE(rules[1].kind == Kind::range && rules[1].number == 3 && rules[1].last_number == 6);
  EXPECT_TRUE(rules[2].kind == Kind::pattern && rules[2].text == "edge_*");
  EXPECT_TRUE(rules[3].kind == Kind::rest);
  for (const NameRule& rule : rules) EXPECT_EQ(rule.name + rule.where, "wall--name wall=1,3-6,edge_*,*");
}

TEST(NameOptions, APointHasTwoOrThreeCoordinates) {
  const std::vector<NameRule> rules = name_option_rules({" out let @21,-1e-1", "top@1,2,3"});
  ASSERT_EQ(rules.size(), 2);
  EXPECT_EQ(rules[0].name, "out let");
  EXPECT_EQ(rules[0].position, (std::vector<double>{21, -0.1}));
  EXPECT_EQ(rules[0].max_distance, max_option_distance);
  EXPECT_EQ(rules[1].position, (std::vector<double>{1, 2, 3}));
}

TEST(NameOptions, MistakesAreRefused) {
  const auto message = [](const std::string& option) {
    return message_of<UsageError>([&] { name_option_rules({option}); });
  };
  for (const char* option : {"wall", "=3", "@1,2", "", " =3"})
    EXPECT_NE(message(option).find("expected NAME=LIST"), std::string::npos) << option;
  for (const char* option : {"w@1", "w@1,2,3,4", "w@a,b", "w@1,", "w@1,inf"})
    EXPECT_NE(message(option).find("a point is X,Y or X,Y,Z"), std::string::npos) << option;
  for (const char* option : {"w=", "w=1,,2", "w=1,"})
    EXPECT_NE(message(option).find("an item of the list is empty"), std::string::npos) << option;
}

TEST(NameOptions, WhatIsNoNumberOrRangeIsAName) {
  for (const char* item : {"-1", "6-3", "1-", "1-2-3", "99999999999"})
    EXPECT_TRUE(name_option_rules({std::string("w=") + item}).front().kind == Kind::pattern) << item;
}

}  // namespace
}  // namespace quadrille::cad
