#include "base/json_string.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

TEST(JsonString, QuotesBackslashesAndControlCharactersAreEscaped) {
  EXPECT_EQ(json_string("inlet"), R"("inlet")");
  EXPECT_EQ(json_string("a \"b\" \\ c"), R"("a \"b\" \\ c")");
  EXPECT_EQ(json_string("a\nb\x01"), R"("a\u000ab\u0001")");
}

TEST(JsonString, OtherCharactersOfUtf8AreCopied) { EXPECT_EQ(json_string("Einlaß €"), "\"Einlaß €\""); }

}  // namespace
}  // namespace quadrille
