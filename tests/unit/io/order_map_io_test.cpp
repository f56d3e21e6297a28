#include "io/order_map_io.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

std::vector<int> read(const std::string& text, int num_elems = 2, int max_order = 12) {
  return read_order_map({{"orders.json", ""}, text}, num_elems, max_order).elem_order;
}

std::string map(const std::string& version, const std::string& elem_order) {
  return R"({"format": "order-map", "version": )" + version + R"(, "elem_order": )" + elem_order + "}";
}

/// The message about a file that is refused.
std::string refusal(const std::string& text) {
  return message_of<FormatError>([&] { read(text); });
}

TEST(OrderMap, later_minor_versions_are_read) {
  const std::vector<int> orders{3, 12};
  EXPECT_EQ(read(map("[1, 0]", "[3, 12]")), orders);
  EXPECT_EQ(read(map("[1, 7]", "[3, 12]")), orders);
}

TEST(OrderMap, other_versions_are_refused_with_two_sentences) {
  EXPECT_NE(refusal(map("[2, 0]", "[3, 12]")).find("newer than this program"), std::string::npos);
  EXPECT_NE(refusal(map("[0, 9]", "[3, 12]")).find("from an older program"), std::string::npos);
  for (const char* version : {"1", "[]", "[1]", "[1, 0, 0]", R"("1.0")", "null"})
    EXPECT_NE(refusal(map(version, "[3, 12]")).find("'version'"), std::string::npos) << version;
}

TEST(OrderMap, rules_are_named) {
  EXPECT_EQ(refusal(map("[1, 0]", "[3]")).substr(0, 7), "ORD-R01");
  EXPECT_EQ(refusal(map("[1, 0]", "[3, 13]")).substr(0, 7), "ORD-R02");
  EXPECT_EQ(refusal(map("[1, 0]", "[0, 3]")).substr(0, 7), "ORD-R02");
}

TEST(OrderMap, anything_else_is_refused_by_the_name_of_the_file) {
  for (const char* text : {"", "[", "[]", "3", "{}", R"({"format": "field"})", R"({"format": ["order-map"]})"})
    EXPECT_NE(refusal(text).find("orders.json"), std::string::npos) << text;
  for (const char* orders : {"3", "[1.5, 2]", R"(["a", 2])", "[[1], 2]", "[-1, 2]", "[1000000, 2]"})
    EXPECT_NE(refusal(map("[1, 0]", orders)).find("elem_order"), std::string::npos) << orders;
  EXPECT_EQ(refusal(map("[1, 0]", "[1e999, 2]")),
            "orders.json: a number is larger than the largest of double precision");
}

TEST(OrderMap, a_file_of_brackets_is_refused) {
  EXPECT_EQ(refusal(std::string(1'000'000, '[')), "orders.json: not valid: nested deeper than 100 levels");
}

}  // namespace
}  // namespace quadrille::io
