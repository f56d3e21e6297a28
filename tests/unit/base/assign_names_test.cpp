#include "base/assign_names.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille {

namespace {

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

using Names = std::vector<std::string>;

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
