#include "base/numbered_names.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

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
