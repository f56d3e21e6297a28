#include "base/name_text.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {

namespace {

TEST(NameText, characters_of_one_to_four_bytes_are_utf8) {
  EXPECT_EQ(utf8_length("a"), 1);
  EXPECT_EQ(utf8_length("\xC3\xA4"), 2);
  EXPECT_EQ(utf8_length("\xE2\x82\xAC!"), 3);
  EXPECT_EQ(utf8_length("\xF0\x9F\x98\x80"), 4);
  EXPECT_EQ(utf8_length("\xF4\x8F\xBF\xBF"), 4) << "U+10FFFF, the last one";
}

TEST(NameText, what_unicode_forbids_is_not_utf8) {
  for (const char* text : {"\x80", "\xC0\xAF", "\xC1\xBF", "\xC3", "\xC3(", "\xE0\x9F\xBF", "\xED\xA0\x80", "\xE2\x82",
                           "\xF0\x8F\xBF\xBF", "\xF4\x90\x80\x80", "\xF5\x80\x80\x80", "\xFF"}) {
    EXPECT_EQ(utf8_length(text), 0);
    EXPECT_FALSE(is_utf8(std::string("good ") + text));
  }
  EXPECT_EQ(utf8_length(""), 0);
  EXPECT_TRUE(is_utf8(""));
}

TEST(NameText, latin1_is_taken_only_where_it_is_no_utf8) {
  EXPECT_EQ(utf8_or_latin1("W\xE4nde"), "W\xC3\xA4nde");
  EXPECT_EQ(utf8_or_latin1("W\xC3\xA4nde"), "W\xC3\xA4nde");
  EXPECT_EQ(utf8_or_latin1("\xFF\x80"), "\xC3\xBF\xC2\x80");
  for (int code = 0; code < 256; ++code) EXPECT_TRUE(is_utf8(utf8_or_latin1({static_cast<char>(code), '\xFF'})));
}

TEST(NameText, names_are_one_trimmed_line) {
  EXPECT_EQ(clean_name("  wall \t"), "wall");
  EXPECT_EQ(clean_name("upper\nside"), "upper side");
  EXPECT_EQ(clean_name("a\x7F"
                       "b\xC2\x85"
                       "c"),
            "a b c");
  EXPECT_EQ(clean_name("a\xFF"
                       "b"),
            "a\xEF\xBF\xBD"
            "b");
  EXPECT_EQ(clean_name(" \n "), "");
  EXPECT_EQ(clean_name(std::string_view("a\0b", 3)), "a b");
  EXPECT_EQ(clean_name("W\xC3\xA4nde aus \xE9\x8B\xBC"), "W\xC3\xA4nde aus \xE9\x8B\xBC");
}

TEST(NameText, what_a_terminal_would_obey_is_not_printed) {
  EXPECT_EQ(printable_text("a\n\xC3\xA9 \t\x1B[31m\x7F\xC2\x9B"
                           "\xFF"),
            "a\n\xC3\xA9 \xEF\xBF\xBD\xEF\xBF\xBD[31m\xEF\xBF\xBD\xEF\xBF\xBD\xEF\xBF\xBD");
}

TEST(Wildcard, AStarIsAnyTextAndAQuestionMarkOneCharacter) {
  const struct {
    const char *text, *pattern;
    bool fits;
  } cases[]{
      {"wall", "wall", true},   {"wall", "Wall", false},    {"wall", "wal", false},      {"wall", "walls", false},
      {"", "", true},           {"", "a", false},           {"edge_12", "edge_*", true}, {"edge_", "edge_*", true},
      {"", "**", true},         {"a_b_b_c", "a*b_c", true}, {"aXbYc", "*X*Y*", true},    {"aYbXc", "*X*Y*", false},
      {"edge_1", "*_2", false}, {"e1", "e?", true},         {"eß", "e?", true},  // of two bytes
      {"e", "e?", false},       {"e12", "e?", false},       {"ßß_1", "*?_1", true}};
  for (const auto& c : cases) EXPECT_EQ(matches_wildcard(c.text, c.pattern), c.fits) << c.text << ' ' << c.pattern;
}

TEST(Wildcard, ManyStarsAreCheap) {
  const std::string text(2000, 'a');
  EXPECT_FALSE(matches_wildcard(text, "*a*a*a*a*a*a*a*a*a*a*b"));
}

const std::vector<std::string> words{"--verbose", "--version", "--size", "--size-near", "--order"};

TEST(NearestWord, HasTheFewestErrors) {
  EXPECT_EQ(nearest_word("--verbos", words), "--verbose");
  EXPECT_EQ(nearest_word("--vresion", words), "--version");
  EXPECT_EQ(nearest_word("--sise", words), "--size");
  EXPECT_EQ(nearest_word("--orders", words), "--order");
}

TEST(NearestWord, ABeginningIsNear) {
  EXPECT_EQ(nearest_word("--vers", words), "--version");
  EXPECT_EQ(nearest_word("--size-n", words), "--size-near");
}

TEST(NearestWord, AMessageHasItBehindTheWord) {
  EXPECT_EQ(did_you_mean("--sise", words), " (did you mean --size?)");
  EXPECT_EQ(did_you_mean("--no-such-option", words), "");
}

TEST(NearestWord, NothingIsNearToAnotherWord) {
  EXPECT_EQ(nearest_word("--no-such-option", words), "");
  EXPECT_EQ(nearest_word("-x", words), "");
  EXPECT_EQ(nearest_word("--size", {}), "");
}

using Names = std::vector<std::string>;

std::string refusal(const std::vector<GivenName>& given) {
  Names names{"a", "b"};
  return message_of<FormatError>([&] { assign_names(names, given, "curve"); });
}

TEST(AssignNames, EachTargetAndThenTheRest) {
  Names names{"a", "b", "c", "d"};
  EXPECT_EQ(assign_names(names, {{"rest", {0, 1, 2, 3}, true}, {"x", {2, 0}}}, "curve"),
            (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(names, (Names{"x", "rest", "x", "rest"}));
  EXPECT_EQ(assign_names(names, {{"y", {1}}}, "curve"), (std::vector<int>{1}));
  EXPECT_EQ(names, (Names{"x", "y", "x", "rest"}));
}

TEST(AssignNames, TwoRestsOfDifferentEntities) {
  Names names{"a", "b", "c", "d"};
  EXPECT_EQ(assign_names(names, {{"outer", {0, 1}, true}, {"inner", {3}, true}, {"x", {1}}}, "curve"),
            (std::vector<int>{0, 1, 3}));
  EXPECT_EQ(names, (Names{"outer", "x", "c", "inner"}));
}

TEST(AssignNames, TwoForOneAreRefusedWithBoth) {
  EXPECT_EQ(refusal({{"x", {1}, false, "n: entry 0"}, {"y", {0, 1}, false, "n: entry 1"}}),
            "n: entry 1 names curve 1, as n: entry 0 does: \"y\" or \"x\"?");
  EXPECT_EQ(refusal({{"x", {0, 1}, true, "n: entry 0"}, {"x", {1}, true, "n: entry 1"}}),
            "n: entry 1 names every other curve, as n: entry 0 does: \"x\" or \"x\"?");
}

TEST(NumberedNames, ReplaceEmptyNamesOnly) {
  Names names{"wall", "", "", "inlet"};
  EXPECT_EQ(replace_empty_names(names, "curve"), (std::vector<int>{1, 2}));
  EXPECT_EQ(names, (Names{"wall", "curve_1", "curve_2", "inlet"}));
}

TEST(NumberedNames, DifferFromAllGivenNames) {
  Names names{"", "", "curve_1", "curve_1_"};
  EXPECT_EQ(replace_empty_names(names, "curve"), (std::vector<int>{0, 1}));
  EXPECT_EQ(names, (Names{"curve_0", "curve_1__", "curve_1", "curve_1_"}));
}

TEST(NumberedNames, ArePresumedFromTheNamesAlone) {
  for (Names names : {Names{"", "", ""}, Names{"a", "", "curve_1"}, Names{"", "b", "b"}, Names{"curve_1", ""}}) {
    const std::vector<int> replaced = replace_empty_names(names, "curve");
    EXPECT_EQ(presumed_numbered_names(names, "curve"), replaced);
  }
  EXPECT_TRUE(presumed_numbered_names({"curve_1", "wall", "curve_2_"}, "curve").empty())
      << "another number, another name, and a mark that nothing requires";
}

}  // namespace

}  // namespace quadrille
