#include "io/size_table_io.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../support/texts.hpp"
#include "base/error.hpp"
#include "io/size_field_io.hpp"

namespace quadrille::io {
namespace {

SizeSources read(const std::string& text, Vec2 origin = {}) {
  return read_size_field({{"sizes.csv", ""}, text}, origin);
}

std::string refusal(const std::string& text) {
  return message_of<FormatError>([&] { read(text); });
}

TEST(SizeTableIo, ThreeColumnsNeedNoHeader) {
  for (const char* text :
       {"0,1,0.5\n2,3,0.25\n", "0 1 0.5\r\n2\t3 0.25", "# made by hand\n0; 1; 0.5\n\n2; 3; 0.25 # fine"}) {
    const SizeSources sources = read(text, {10, 20});
    EXPECT_TRUE(sources.is_table);
    ASSERT_EQ(sources.points.size(), 2u) << text;
    EXPECT_EQ(sources.points[0].position, (Vec2{-10, -19}));
    EXPECT_EQ(sources.points[1].position, (Vec2{-8, -17}));
    EXPECT_EQ(sources.points[1].size, 0.25);
  }
}

TEST(SizeTableIo, AHeaderNamesTheColumns) {
  const SizeSources sources =
      read("\"error\",\"size\",\"Points:0\",\"Points:1\",\"Points:2\"\n9,0.5,1,2,0\n8,0.25,3,4,0\n");
  ASSERT_EQ(sources.points.size(), 2u);
  EXPECT_EQ(sources.points[0].position, (Vec2{1, 2}));
  EXPECT_EQ(sources.points[1].size, 0.25);
  EXPECT_EQ(read("Y X Size\n1 2 3").points[0].position, (Vec2{2, 1}));
}

TEST(SizeTableIo, WhatIsNoTableIsRefusedWithTheLine) {
  expect_contains(refusal("0,1,0.5\n0,1\n"), "sizes.csv:2: expected 3 numbers, found 2");
  expect_contains(refusal("0,1,0.5,7\n"), "sizes.csv:1: expected 3 numbers, found 4");
  expect_contains(refusal("x,y,size\n\n1,2,-3\n"), "sizes.csv:3: the size -3 must be greater than 0 (SIZ-R01)");
  expect_contains(refusal("x,y,size\n1,two,3\n"), "sizes.csv:2: 'two' is not a number");
  expect_contains(refusal("x,y,size\n1,nan,3\n"), "sizes.csv:2: 'nan' is not a number");
  expect_contains(refusal("x,y,h\n1,2,3\n"), "sizes.csv:1: there is no column size, only x, y, h");
  expect_contains(refusal("x,y,size\n"), "there are no points");
  expect_contains(refusal("<?xml version=\"1.0\"?><VTKFile>"), "python3 -m quadrille.vtu_sizes sizes.csv");
}

TEST(SizeTableIo, JsonIsNoTable) { EXPECT_FALSE(is_size_table({{"a", ""}, " {\"format\": 1}"})); }

}  // namespace
}  // namespace quadrille::io
