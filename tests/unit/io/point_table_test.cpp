#include "io/point_table.hpp"

#include <gtest/gtest.h>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {
namespace {

const std::vector<std::vector<std::string>> columns{{"x", "points:0"}, {"y"}};

InputFile file(const std::string& text) { return {{"table.csv", ""}, text}; }

bool says(const std::string& text, const std::string& part) {
  return contains(message_of<FormatError>([&] { table_rows(file(text), columns); }), part);
}

TEST(PointTable, ColumnsAreFoundByNameInAnyOrder) {
  const std::vector<TableRow> rows = table_rows(file("# sizes\nY;size;Points:0\n\n2;9;1  # first\n4;9;3\n"), columns);
  ASSERT_EQ(rows.size(), 2u);
  EXPECT_EQ(rows[0].line, 4);
  EXPECT_EQ(rows[0].values, std::vector<double>({1, 2}));
  EXPECT_EQ(rows[1].values, std::vector<double>({3, 4}));
}

TEST(PointTable, WithoutAHeadingColumnsAreInOrder) {
  EXPECT_EQ(table_rows(file("1 2\n3 4\n"), columns)[1].values, std::vector<double>({3, 4}));
  EXPECT_TRUE(table_heading(file("1 2\n")).empty());
  EXPECT_EQ(table_heading(file("# a comment\nX,Y\n1,2\n")), std::vector<std::string>({"x", "y"}));
}

TEST(PointTable, FaultsAreNamedWithTheLine) {
  EXPECT_TRUE(says("1 2 3\n", "table.csv:1: expected 2 numbers, found 3"));
  EXPECT_TRUE(says("1 2\n3 b\n", "table.csv:2: 'b' is not a number"));
  EXPECT_TRUE(says("x,z\n1,2\n", "there is no column y, only x, z"));
  EXPECT_TRUE(says("x,y\n", "there are no points"));
}

TEST(PointTable, JsonAndXmlAreNone) {
  EXPECT_TRUE(is_point_table(file(" 1 2\n")));
  EXPECT_FALSE(is_point_table(file("\n{\"format\": 1}")));
  EXPECT_FALSE(is_point_table(file("<VTKFile>")));
  EXPECT_FALSE(is_point_table(file(" ")));
}

}  // namespace
}  // namespace quadrille::io
