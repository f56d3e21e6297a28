#include "base/enum_names.hpp"

#include <gtest/gtest.h>

namespace quadrille {
namespace {

namespace elsewhere {
enum class Speed { slow, fast, nameless };
constexpr auto enum_names(Speed) { return std::to_array({"slow", "very-fast"}); }
enum class Unnamed { a };
}  // namespace elsewhere

using elsewhere::Speed;

TEST(EnumNames, EveryValueAndNameIsFoundFromAnotherNamespace) {
  EXPECT_EQ(enum_name(Speed::fast), "very-fast");
  EXPECT_EQ(enum_value<Speed>("slow"), Speed::slow);
  EXPECT_EQ(enum_value<Speed>("very-fast"), Speed::fast);
  EXPECT_EQ(all_enum_names<Speed>(), (std::vector<std::string>{"slow", "very-fast"}));
}

TEST(EnumNames, AnUnknownNameHasNoValue) {
  EXPECT_EQ(enum_value<Speed>("fast"), std::nullopt);
  EXPECT_EQ(enum_value<Speed>(""), std::nullopt);
}

TEST(EnumNames, AValueWithoutANameIsADefect) { EXPECT_THROW(enum_name(Speed::nameless), Defect); }

TEST(EnumNames, OnlyEnumsWithATableAreNamed) {
  EXPECT_TRUE(NamedEnum<Speed>);
  EXPECT_FALSE(NamedEnum<elsewhere::Unnamed>);
  EXPECT_FALSE(NamedEnum<int>);
}

TEST(Alternatives, AreListedAsASentenceDoes) {
  EXPECT_EQ(alternatives({"a"}), "a");
  EXPECT_EQ(alternatives({"a", "b"}), "a or b");
  EXPECT_EQ(alternatives({"a", "b", "c"}), "a, b or c");
}

}  // namespace
}  // namespace quadrille
