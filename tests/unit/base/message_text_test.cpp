#include "base/message_text.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace quadrille {

namespace {

TEST(Counted, OneIsSingular) {
  EXPECT_EQ(counted(0, "block"), "0 blocks");
  EXPECT_EQ(counted(std::size_t{1}, "irregular node"), "1 irregular node");
  EXPECT_EQ(counted(2, "block"), "2 blocks");
}

TEST(PositionText, HasSixDigits) {
  EXPECT_EQ(position_text(Vec2{1.5, -2}), "(1.5, -2)");
  EXPECT_EQ(position_text(Vec2{1.0 / 3, 1e-9}), "(0.333333, 1e-09)");
  EXPECT_EQ(position_text(Vec2{1234567, 0}), "(1.23457e+06, 0)");
}

TEST(PositionText, OfAPointInSpaceHasNoRoundingErrors) {
  EXPECT_EQ(position_text(Vec3{1, 1e-15, -2.5}), "(1, 0, -2.5)");
}

TEST(PositionText, NeverHasNan) {
  for (const double bad : {std::nan(""), -std::nan(""), HUGE_VAL})
    for (const std::string& text : {position_text(Vec2{bad, 1}), rounded_position_text(Vec2{1, bad})}) {
      EXPECT_NE(text.find("internal error"), std::string::npos) << text;
      EXPECT_EQ(text.find("nan"), std::string::npos) << text;
      EXPECT_EQ(text.find("inf"), std::string::npos) << text;
    }
}

TEST(JsonString, QuotesBackslashesAndControlCharactersAreEscaped) {
  EXPECT_EQ(json_string("inlet"), R"("inlet")");
  EXPECT_EQ(json_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(json_string("a\nb\x01"), R"("a\u000ab\u0001")");
}

TEST(JsonString, OtherCharactersOfUtf8AreCopied) { EXPECT_EQ(json_string("Einlaß €"), "\"Einlaß €\""); }

}  // namespace

}  // namespace quadrille
