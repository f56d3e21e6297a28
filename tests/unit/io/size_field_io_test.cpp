#include "io/size_field_io.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::io {

namespace {

SizeSources read(const std::string& text) { return read_size_field({{"sizes.json", ""}, text}); }

std::string field(const std::string& members, const std::string& version = "[1, 0]") {
  return R"({"format": "size-field", "version": )" + version + ", " + members + "}";
}

/// The message about a file that is refused.
std::string refusal(const std::string& text) {
  return message_of<FormatError>([&] { read(text); });
}

bool says(const std::string& text, const std::string& part) { return contains(refusal(text), part); }

TEST(SizeFieldIo, PointsAndBoxesAreRead) {
  const SizeSources sources = read(field(R"("growth": 1.5, "points": [{"position": [1, 2], "size": 0.1},
    {"position": [3, 4], "size": 0.2, "radius": 0.5}], "boxes": [{"low": [0, 1], "high": [2, 3], "size": 0.3}])"));
  EXPECT_EQ(sources.growth, 1.5);
  ASSERT_EQ(sources.points.size(), 2u);
  EXPECT_EQ(sources.points[0].radius, 0);
  EXPECT_EQ(sources.points[1].position, (Vec3{3, 4}));
  EXPECT_EQ(sources.points[1].size, 0.2);
  EXPECT_EQ(sources.points[1].radius, 0.5);
  ASSERT_EQ(sources.boxes.size(), 1u);
  EXPECT_EQ(sources.boxes[0].low, (Vec3{0, 1}));
  EXPECT_EQ(sources.boxes[0].high, (Vec3{2, 3}));
  EXPECT_EQ(sources.boxes[0].size, 0.3);
}

TEST(SizeFieldIo, PositionsInSpaceHaveThreeCoordinates) {
  const SizeSources sources = read(field(R"("points": [{"position": [1, 2, 3], "size": 1}],
    "boxes": [{"low": [5, 6, 7], "high": [7, 8, 9], "size": 1}])"));
  EXPECT_TRUE(sources.is_in_space);
  EXPECT_EQ(sources.points[0].position, (Vec3{1, 2, 3}));
  EXPECT_EQ(sources.boxes[0].high, (Vec3{7, 8, 9}));
  EXPECT_FALSE(read(field(R"("points": [{"position": [1, 2], "size": 1}])")).is_in_space);
  EXPECT_TRUE(says(field(R"("points": [{"position": [1, 2], "size": 1}, {"position": [1, 2, 3], "size": 1}])"),
                   "as many coordinates"));
  EXPECT_TRUE(says(field(R"("boxes": [{"low": [0, 0, 1], "high": [1, 1, 0], "size": 1}])"), "SIZ-R02"));
}

TEST(SizeFieldIo, RulesAreNamedWithThePlace) {
  EXPECT_TRUE(says(field(R"("points": [{"position": [0, 0], "size": 1}, {"position": [0, 0], "size": 0}])"),
                   "'points[1].size'"));
  EXPECT_TRUE(says(field(R"("points": [{"position": [0, 0], "size": -1}])"), "SIZ-R01"));
  EXPECT_TRUE(says(field(R"("points": [{"position": [0, 0], "size": 1, "radius": -1}])"), "SIZ-R01"));
  EXPECT_TRUE(says(field(R"("growth": 1, "points": [])"), "SIZ-R01"));
  EXPECT_TRUE(says(field(R"("boxes": [{"low": [0, 1], "high": [1, 0], "size": 1}])"), "SIZ-R02"));
  EXPECT_TRUE(says(field(R"("growth": 1.5)"), "SIZ-R03"));
  EXPECT_EQ(refusal(field(R"("boxes": [])")), "");
}

TEST(SizeFieldIo, AnythingElseIsRefusedByTheNameOfTheFile) {
  for (const char* text : {"", "[", "[]", "3", "{}", R"({"format": "field"})", R"({"format": ["size-field"]})"})
    EXPECT_TRUE(says(text, "sizes.json")) << text;
  for (const char* members :
       {R"("points": 3)", R"("points": [3])", R"("points": [{"size": 1}])", R"("points": [{"position": [0, 0]}])",
        R"("points": [{"position": [0], "size": 1}])", R"("points": [{"position": [0, "a"], "size": 1}])",
        R"("points": [{"position": [0, 0], "size": "1"}])", R"("boxes": [{"low": [0, 0], "size": 1}])"})
    EXPECT_TRUE(says(field(members), "sizes.json")) << members;
}

TEST(SizeFieldIo, OtherVersionsAreRefusedWithTwoSentences) {
  EXPECT_TRUE(says(field(R"("points": [])", "[2, 0]"), "newer than this program"));
  EXPECT_TRUE(says(field(R"("points": [])", "[0, 9]"), "from an older program"));
  EXPECT_EQ(refusal(field(R"("points": [])", "[1, 7]")), "");
}

SizeSources read_table(const std::string& text) { return read_size_field({{"sizes.csv", ""}, text}); }

std::string table_refusal(const std::string& text) {
  return message_of<FormatError>([&] { read_table(text); });
}

TEST(SizeTableIo, ThreeColumnsNeedNoHeader) {
  for (const char* text :
       {"0,1,0.5\n2,3,0.25\n", "0 1 0.5\r\n2\t3 0.25", "# made by hand\n0; 1; 0.5\n\n2; 3; 0.25 # fine"}) {
    const SizeSources sources = read_table(text);
    EXPECT_TRUE(sources.is_table);
    ASSERT_EQ(sources.points.size(), 2u) << text;
    EXPECT_EQ(sources.points[0].position, (Vec3{0, 1}));
    EXPECT_EQ(sources.points[1].position, (Vec3{2, 3}));
    EXPECT_EQ(sources.points[1].size, 0.25);
  }
}

TEST(SizeTableIo, AHeaderNamesTheColumns) {
  const SizeSources sources =
      read_table("\"error\",\"size\",\"Points:0\",\"Points:1\",\"Points:2\"\n9,0.5,1,2,0\n8,0.25,3,4,0\n");
  ASSERT_EQ(sources.points.size(), 2u);
  EXPECT_EQ(sources.points[0].position, (Vec3{1, 2, 0}));
  EXPECT_TRUE(sources.is_in_space);
  EXPECT_EQ(sources.points[1].size, 0.25);
  EXPECT_EQ(read_table("x z y size\n1 2 3 4").points[0].position, (Vec3{1, 3, 2}));
  EXPECT_FALSE(read_table("x y size\n1 2 3").is_in_space);
  EXPECT_EQ(read_table("Y X Size\n1 2 3").points[0].position, (Vec3{2, 1}));
}

TEST(SizeTableIo, WhatIsNoTableIsRefusedWithTheLine) {
  expect_contains(table_refusal("0,1,0.5\n0,1\n"), "sizes.csv:2: expected 3 numbers, found 2");
  expect_contains(table_refusal("0,1,0.5,7\n"), "sizes.csv:1: expected 3 numbers, found 4");
  expect_contains(table_refusal("x,y,size\n\n1,2,-3\n"), "sizes.csv:3: the size -3 must be greater than 0 (SIZ-R01)");
  expect_contains(table_refusal("x,y,size\n1,two,3\n"), "sizes.csv:2: 'two' is not a number");
  expect_contains(table_refusal("x,y,size\n1,nan,3\n"), "sizes.csv:2: 'nan' is not a number");
  expect_contains(table_refusal("x,y,h\n1,2,3\n"), "sizes.csv:1: there is no column size, only x, y, h");
  expect_contains(table_refusal("x,y,size\n"), "there are no points");
  expect_contains(table_refusal("<?xml version=\"1.0\"?><VTKFile>"), "python3 -m quadrille.vtu_sizes sizes.csv");
}

TEST(SizeTableIo, JsonIsNoTable) { EXPECT_FALSE(read_table(' ' + field(R"("points": [])")).is_table); }

}  // namespace
}  // namespace quadrille::io
