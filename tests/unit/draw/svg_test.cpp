#include "draw/svg.hpp"

#include <gtest/gtest.h>

namespace quadrille::draw {
namespace {

TEST(Svg, NumbersAreShortAndNeverMinusZero) {
  EXPECT_EQ(svg_number(1.5), "1.5");
  EXPECT_EQ(svg_number(-2), "-2");
  EXPECT_EQ(svg_number(100), "100");
  EXPECT_EQ(svg_number(-0.001), "0");
  EXPECT_EQ(svg_number(0.126), "0.13");
  EXPECT_EQ(svg_number(0.1234567, 4), "0.1235");
}

TEST(Svg, SpecialCharactersAreEscaped) {
  EXPECT_EQ(xml_escaped("a<b> & \"c\" 'd'\n"), "a&lt;b&gt; &amp; &quot;c&quot; &#39;d&#39; ");
  EXPECT_EQ(svg_element("path", {{"d", "M0 0"}, {"class", "a\"b"}}, "<1>"),
            "<path d=\"M0 0\" class=\"a&quot;b\"><title>&lt;1&gt;</title></path>");
  EXPECT_EQ(svg_element("g", {}), "<g/>");
}

TEST(Svg, PathDataIsCompact) {
  PathData path;
  path.move_to({0, 0});
  path.line_to({1, -2.5});
  path.cubic_to({1, 2}, {-3, 4}, {5, 6});
  path.relative_lines({{-1, 0}, {0, 0.5}});
  path.close();
  EXPECT_EQ(path.str(), "M0 0L1-2.5C1 2-3 4 5 6l-1 0 0 0.5z");
}

}  // namespace
}  // namespace quadrille::draw
