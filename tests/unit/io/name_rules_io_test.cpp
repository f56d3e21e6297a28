#include "io/name_rules_io.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

using Kind = NameRule::Kind;

std::vector<NameRule> boundary(const std::string& json) { return read_boundary_names({{"names.json", ""}, json}); }
std::vector<NameRule> blocks(const std::string& json) { return read_block_names({{"names.json", ""}, json}); }

std::string refusal(const std::string& json, bool is_block = false) {
  return message_of<FormatError>([&] { is_block ? blocks(json) : boundary(json); });
}

TEST(NameRules, AnObjectNamesByNameOrNumber) {
  const auto rules = boundary(R"({"a": "inlet", "2": " wall ", "*": "rest"})");
  ASSERT_EQ(rules.size(), 3U);
  EXPECT_EQ(rules[0].kind, Kind::key);
  EXPECT_EQ(rules[0].text, "a");
  EXPECT_EQ(rules[0].number, -1);
  EXPECT_EQ(rules[0].name, "inlet");
  EXPECT_EQ(rules[0].where, "names.json: \"a\"");
  EXPECT_EQ(rules[1].kind, Kind::key) << "a curve may be called 2";
  EXPECT_EQ(rules[1].number, 2);
  EXPECT_EQ(rules[1].name, "wall") << "trimmed";
  EXPECT_EQ(rules[2].kind, Kind::rest);
  EXPECT_TRUE(boundary("{}").empty());
}

TEST(NameRules, AListNamesByIdOldNameOrPlace) {
  const auto rules = boundary(R"([{"id": 3, "name": "a"}, {"name": "b", "old_name": "3"},
    {"near": [0.5, -1e-3], "name": "c"}, {"near": [1, 2, 3], "name": "d"}, {"id": "*", "name": "e"}])");
  ASSERT_EQ(rules.size(), 5U);
  EXPECT_EQ(rules[0].kind, Kind::number);
  EXPECT_EQ(rules[0].number, 3);
  EXPECT_EQ(rules[0].where, "names.json: entry 0");
  EXPECT_EQ(rules[1].kind, Kind::old_name);
  EXPECT_EQ(rules[1].text, "3");
  EXPECT_EQ(rules[1].name, "b");
  EXPECT_EQ(rules[2].kind, Kind::position);
  EXPECT_EQ(rules[2].position, (std::vector<double>{0.5, -1e-3}));
  EXPECT_EQ(rules[3].position.size(), 3U);
  EXPECT_EQ(rules[4].kind, Kind::rest);
  EXPECT_EQ(rules[4].where, "names.json: entry 4");
}

TEST(NameRules, ATextNamesAll) {
  for (const auto& rules : {boundary("\"wall\""), blocks("\"wall\"")}) {
    ASSERT_EQ(rules.size(), 1U);
    EXPECT_EQ(rules[0].kind, Kind::rest);
    EXPECT_EQ(rules[0].name, "wall");
  }
}

TEST(NameRules, BlocksHaveNumbersAndPlaces) {
  const auto rules = blocks(R"([{"at": [0.1, 0.2], "name": "fluid"}, {"id": 0, "name": "solid"}])");
  ASSERT_EQ(rules.size(), 2U);
  EXPECT_EQ(rules[0].kind, Kind::position);
  EXPECT_EQ(rules[1].kind, Kind::number);
  EXPECT_EQ(blocks(R"({"7": "x"})")[0].kind, Kind::number);
  EXPECT_NE(refusal(R"({"fluid": "x"})", true).find("number of a block"), std::string::npos);
  for (const char* json : {R"([{"near": [0, 0], "name": "x"}])", R"([{"old_name": "a", "name": "x"}])"})
    EXPECT_NE(refusal(json, true).find(R"(is not one of "id", "at", and "name")"), std::string::npos) << json;
}

TEST(NameRules, WhatIsNoRuleIsRefusedWithItsEntry) {
  EXPECT_EQ(refusal(R"({"a": "x", "a": "y"})"), "names.json: the key \"a\" occurs twice");
  EXPECT_EQ(refusal(R"({"a": " "})"), "names.json: \"a\": the new name must be a text that is not empty");
  for (const char* entry :
       {R"({"id": 0})", R"({"name": "x"})", R"({"id": 0, "near": [0, 0], "name": "x"})", "3",
        R"({"id": 0.5, "name": "x"})", R"({"id": "0", "name": "x"})", R"({"near": 3, "name": "x"})",
        R"({"near": [0], "name": "x"})", R"({"near": [0, "1"], "name": "x"})", R"({"near": [0, 1, 2, 3], "name": "x"})",
        R"({"near": [0, 1], "name": ""})", R"({"near": [0, 1], "name": 3})", R"({"at": [0, 1], "name": "x"})",
        R"({"old_name": 3, "name": "x"})"})
    EXPECT_EQ(refusal(std::string(R"([{"id": 1, "name": "good"}, )") + entry + "]").find("names.json: entry 1: "), 0U)
        << entry << ": " << refusal(std::string("[") + entry + "]");
  for (const char* json : {"", "3", "null", "{\"a\": 3}", "{\"a\"", "\"\"", "\"\xFF\"", "[[]]"})
    EXPECT_EQ(refusal(json).find("names.json: "), 0U) << json;
}

TEST(NameRules, NumbersBeyondDoublePrecisionAreRefused) {
  for (const char* json : {R"([{"near": [1e999, 0], "name": "x"}])", R"({"a": -1e999})", "1e999"})
    EXPECT_EQ(refusal(json), "names.json: a number is larger than the largest of double precision") << json;
}

TEST(NameRules, NumbersOutOfRangeMeetNothing) {
  EXPECT_EQ(boundary(R"([{"id": 99999999999, "name": "x"}])")[0].number, -1);
  EXPECT_EQ(boundary(R"([{"id": -4, "name": "x"}])")[0].number, -1);
  EXPECT_EQ(boundary(R"({"99999999999": "x"})")[0].number, -1);
}

TEST(NameRules, AFileOfBracketsIsRefused) {
  EXPECT_EQ(refusal(std::string(1'000'000, '[')), "names.json: not valid: nested deeper than 100 levels");
  std::string many = "{";
  for (int i = 0; i < 20000; ++i) many += fmt::format(R"("{}": "a", )", i);
  EXPECT_EQ(refusal(many + "\"x\": \"a\"}"), "names.json: not valid: an object has more than 10000 keys");
  std::string objects = "[";
  for (int i = 0; i < 400'000; ++i) objects += "{\"a\":{}},";
  EXPECT_NE(refusal(objects + "{}]"), "") << "in less than a second";
}

}  // namespace
}  // namespace quadrille::io
