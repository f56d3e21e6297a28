#include "export/names_table.hpp"

#include <gtest/gtest.h>

namespace quadrille::exports {
namespace {

TEST(NamesTable, ListsGroupsWithTheirNumbers) {
  Groups groups;
  groups.boundary_names = {"wall", "outlet"};
  groups.region_names = {"block_0"};
  const SideFile table = names_table(groups, 1, 3);
  EXPECT_EQ(table.name.ending, ".names.json");
  EXPECT_FALSE(table.is_binary);
  EXPECT_EQ(table.bytes, R"({
  "boundaries": [
    {"id": 1, "name": "wall"},
    {"id": 2, "name": "outlet"}
  ],
  "regions": [
    {"id": 3, "name": "block_0"}
  ]
}
)");
}

TEST(NamesTable, EscapesWhatJsonAsksFor) {
  const SideFile table = names_table({{7, "a\"b\\c\n\xc3\xa4", ""}}, {});
  EXPECT_EQ(table.bytes,
            "{\n  \"boundaries\": [\n    {\"id\": 7, \"name\": \"a\\\"b\\\\c\\u000a\xc3\xa4\"}\n  ],\n  \"regions\": "
            "[]\n}\n");
}

TEST(NamesTable, SaysWhatTheFileCallsAGroup) {
  const SideFile table = names_table({{1, "inner wall", "inner_wall"}}, {});
  EXPECT_NE(table.bytes.find(R"({"id": 1, "name": "inner wall", "tag": "inner_wall"})"), std::string::npos);
}

}  // namespace
}  // namespace quadrille::exports
