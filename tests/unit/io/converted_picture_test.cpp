#include "io/converted_picture.hpp"

#include <gtest/gtest.h>

#include "base/error.hpp"

namespace quadrille::io {
namespace {

TEST(ConvertedPicture, TheEndingChoosesTheFormat) {
  EXPECT_EQ(picture_format("a.png"), PictureFormat::png);
  EXPECT_EQ(picture_format("folder.png/a.pdf"), PictureFormat::pdf);
  EXPECT_EQ(picture_format("folder.png/a.svg"), PictureFormat::svg);
  EXPECT_EQ(picture_format("-"), PictureFormat::svg);
  EXPECT_EQ(picture_format("folder.gif/a"), PictureFormat::svg);
  EXPECT_EQ(picture_format("/dev/stdout"), PictureFormat::svg);
  EXPECT_EQ(picture_format("A.PDF"), PictureFormat::pdf);
  EXPECT_THROW(picture_format("a.gif"), UsageError);
  EXPECT_THROW(picture_format("a.svg.bak"), UsageError);
}

TEST(ConvertedPicture, SvgIsLeftAsItIs) {
  EXPECT_EQ(converted_picture("<svg/>", PictureFormat::svg, "a.svg"), "<svg/>");
}

TEST(ConvertedPicture, WhatIsNoSvgIsAnOutputError) {
  EXPECT_THROW(converted_picture("no picture", PictureFormat::png, "a.png"), OutputError);
}

}  // namespace
}  // namespace quadrille::io
