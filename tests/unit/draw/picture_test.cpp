#include "draw/picture.hpp"

#include <gtest/gtest.h>

#include <string>

#include "../hand_made.hpp"
#include "../support/texts.hpp"
#include "base/error.hpp"

namespace quadrille::draw {
namespace {

DrawOptions wide(int width) {
  DrawOptions options;
  options.width = width;
  return options;
}

TEST(PictureBox, GrowsFromNothing) {
  PictureBox box;
  EXPECT_TRUE(box.empty());
  box.include({2, 3});
  EXPECT_FALSE(box.empty());
  box.include({1, 5});
  EXPECT_EQ(box.lower, (Vec2{1, 3}));
  EXPECT_EQ(box.upper, (Vec2{2, 5}));
}

TEST(PictureBox, OfAFaceHoldsItsCurvesNotTheirPoles) {
  const PictureBox box = bounding_box(hand_made::cut_annulus(1).face);
  EXPECT_NEAR(distance(box.lower, {-1, -1}), 0, 1e-3);
  EXPECT_NEAR(distance(box.upper, {1, 1}), 0, 1e-3);
}

TEST(Picture, OneScaleForBothDirectionsWithMarginsAround) {
  const Picture flat({{10, 20}, {14, 21}}, wide(472), "", "");  // 400 pixels between the margins
  EXPECT_EQ(flat.scale(), 100);
  EXPECT_EQ(flat.size(), (Vec2{400, 100}));
  EXPECT_EQ(flat.at({10, 20}), (Vec2{0, 0}));
  EXPECT_EQ(flat.at({11, 20.5}), (Vec2{100, 50}));
}

TEST(Picture, ATallFaceIsAtMostATenthHigherThanThePictureIsWide) {
  const Picture tall({{0, 0}, {1, 10}}, wide(472), "", "");
  EXPECT_NEAR(tall.size().y, 1.1 * 400, 1e-9);
  EXPECT_NEAR(tall.scale(), 44, 1e-9);
}

TEST(Picture, NothingToDrawIsAPictureToo) {
  const Picture none(PictureBox(), wide(472), "", "");
  EXPECT_EQ(none.size(), (Vec2{400, 400}));
  EXPECT_FALSE(contains(none.str(), "inf"));
}

TEST(Picture, TheDrawingIsFlippedAndTextsAreNot) {
  Picture picture({{0, 0}, {4, 1}}, wide(472), "a < b", "c & d");
  picture.add("<drawn/>");
  picture.text({100, 30}, "label", "x > y");
  const std::string svg = picture.str();
  EXPECT_TRUE(contains(svg, "<title>a &lt; b</title>"));
  EXPECT_TRUE(contains(svg, "c &amp; d"));
  const std::size_t drawing = svg.find("<g id=\"drawing\" transform=\"translate(36 176) scale(1 -1)\">");
  const std::size_t texts = svg.find("<g id=\"texts\" transform=\"translate(36 76)\">");
  ASSERT_NE(drawing, std::string::npos) << svg.substr(svg.find("<g id"));
  ASSERT_NE(texts, std::string::npos);
  EXPECT_LT(drawing, svg.find("<drawn/>"));
  EXPECT_LT(svg.find("<drawn/>"), texts);
  EXPECT_TRUE(contains(svg.substr(texts), "x=\"100\" y=\"74\"")) << "100 - 30, and 4 to the middle of the letters";
  EXPECT_TRUE(contains(svg.substr(texts), "x &gt; y"));
}

TEST(Picture, WhatIsBareIsTheDrawingAlone) {
  DrawOptions options;
  options.width = 272;
  options.is_bare = true;
  Picture picture({{0, 0}, {2, 1}}, options, "title", "caption");
  picture.add("<mark/>");
  picture.text({1, 1}, "label", "text");
  picture.legend_scale("mm");
  const std::string svg = picture.str();
  EXPECT_NE(svg.find("viewBox=\"0 0 212 112\""), std::string::npos) << "200 x 100 pixels and margins of 6";
  EXPECT_NE(svg.find("<mark/>"), std::string::npos);
  for (const char* omitted : {"caption<", "text<", "id=\"legend\""}) EXPECT_EQ(svg.find(omitted), std::string::npos);
}

TEST(Picture, ClippedGroupsReferToOutlinesOfTheirOwn) {
  Picture picture({{0, 0}, {1, 1}}, wide(200), "", "");
  EXPECT_FALSE(contains(picture.str(), "<defs>"));
  picture.open_clipped_group("cells", "M0 0L1 0z");
  picture.close_group();
  picture.open_clipped_group("cells", "M0 0L2 0z");
  picture.close_group();
  const std::string svg = picture.str();
  std::vector<std::string> ids;
  for (std::size_t at = svg.find("url(#"); at != std::string::npos; at = svg.find("url(#", at + 1))
    ids.push_back(svg.substr(at + 5, svg.find(')', at) - at - 5));
  ASSERT_EQ(ids.size(), 2u);
  EXPECT_NE(ids[0], ids[1]);
  for (const std::string& id : ids) EXPECT_TRUE(contains(svg, "id=\"" + id + "\"")) << id;
}

TEST(Picture, LegendEntriesThatDoNotFitBeginANewRow) {
  const auto height = [](int entries) {
    Picture picture({{0, 0}, {4, 1}}, wide(472), "", "");
    for (int k = 0; k < entries; ++k) picture.legend_mark("<mark/>", "nineteen letters ..");
    const std::string svg = picture.str(), key = "height=\"";
    return std::stoi(svg.substr(svg.find(key) + key.size()));
  };
  // An entry is about 150 pixels wide.
  EXPECT_EQ(height(1), height(2));
  EXPECT_EQ(height(3) - height(2), 34);
  EXPECT_GT(height(1), height(0));
}

TEST(RoundLength, IsOneTwoOrFiveTimesAPowerOfTen) {
  EXPECT_EQ(round_length(1), 1);
  EXPECT_EQ(round_length(1.99), 1);
  EXPECT_EQ(round_length(2), 2);
  EXPECT_EQ(round_length(49), 20);
  EXPECT_DOUBLE_EQ(round_length(0.0051), 0.005);
  EXPECT_DOUBLE_EQ(round_length(9.99e-7), 5e-7);
}

TEST(Picture, TheScaleBarHasARoundLengthAndItsUnit) {
  Picture picture({{0, 0}, {40, 10}}, wide(472), "", "");  // 10 pixels a unit
  picture.legend_scale("mm");
  const std::string svg = picture.str();
  EXPECT_TRUE(contains(svg, ">10 mm</text>"));
  EXPECT_TRUE(contains(svg, "h100m")) << "ten units";
}

TEST(Picture, TheFileStandsBesideTheTitleOrBelowItIfThereIsNoRoom) {
  DrawOptions options = wide(472);
  options.file = "a < b.h5";
  const Picture beside({{0, 0}, {4, 1}}, options, "title", "caption");
  EXPECT_TRUE(contains(beside.str(), "<text class=\"file\" x=\"436\" y=\"32\">a &lt; b.h5</text>"));
  options.file = "a_name_that_is_too_long_for_a_place_beside_the_title.h5";
  const std::string svg = Picture({{0, 0}, {4, 1}}, options, "title", "caption").str();
  EXPECT_FALSE(contains(svg, "class=\"file\""));
  EXPECT_TRUE(contains(svg, "<text class=\"caption\" x=\"36\" y=\"70\">a_name"));
}

TEST(Picture, AWindowIsClippedAndShowsNoTextsOutside) {
  DrawOptions options = wide(472);
  options.window = Window{{11, 20}, {12, 21}};
  const PictureBox whole{{0, 0}, {4, 1}};
  const PictureBox box = shown_box(whole, {10, 20}, options);
  EXPECT_EQ(box.lower, (Vec2{1, 0}));
  EXPECT_EQ(box.upper, (Vec2{2, 1}));
  Picture picture(box, options, "", "");
  picture.text({100, 100}, "label", "inside");
  picture.text({-1, 100}, "label", "outside");
  const std::string svg = picture.str();
  EXPECT_TRUE(contains(svg, ">inside<") && !contains(svg, ">outside<"));
  EXPECT_TRUE(contains(svg, "<clipPath id=\"window\"><rect width=\"400\" height=\"400\"/>"));
  options.window = Window{{0, 0}, {1, 1}};
  EXPECT_THROW(shown_box(whole, {10, 20}, options), UsageError);
  EXPECT_EQ(shown_box(whole, {10, 20}, {}).upper, whole.upper);
}

TEST(Picture, LinesKeepTheirWidthWhenThePictureIsEnlarged) {
  EXPECT_TRUE(contains(Picture(PictureBox(), wide(472), "", "").str(), "vector-effect:non-scaling-stroke"));
}

TEST(Picture, ACaptionThatIsTooWideTakesLinesAndMovesTheDrawingDown) {
  const auto svg = [](const std::string& caption) {
    return Picture({{0, 0}, {4, 1}}, wide(300), "title", caption).str();
  };
  const std::string line = "a caption of one line", lines = "a caption of lines that are wider than the picture";
  EXPECT_TRUE(contains(svg(line), ">a caption of one line</text>"));
  EXPECT_TRUE(contains(svg(lines), ">a caption of lines that are</text>"));
  EXPECT_TRUE(contains(svg(lines), ">wider than the picture</text>"));
  EXPECT_TRUE(contains(svg(line), "height=\"193\"") && contains(svg(lines), "height=\"211\"")) << svg(lines);
}

TEST(WrappedText, BreaksBetweenWordsAndLeavesLongWordsWhole) {
  EXPECT_EQ(wrapped_text("", 10, 100), (std::vector<std::string>{}));
  EXPECT_EQ(wrapped_text("aa bb cc", 10, 30), (std::vector<std::string>{"aa bb", "cc"}));  // 5.6 pixels a letter
  EXPECT_EQ(wrapped_text("a longword b", 10, 20), (std::vector<std::string>{"a", "longword", "b"}));
}

TEST(TextWidth, CountsLettersNotBytes) {
  EXPECT_EQ(text_width("abcd", 10), text_width("\xc3\xa4\xc3\xb6\xc3\xbc\xc3\x9f", 10));
  EXPECT_EQ(text_width("", 10), 0);
  EXPECT_EQ(text_width("ab", 20), 2 * text_width("ab", 10));
}

}  // namespace
}  // namespace quadrille::draw
