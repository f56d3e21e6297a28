#include "draw/svg.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <sstream>

#include "base/angle.hpp"

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

struct Piece {
  char command;
  std::vector<Vec2> points;
};

/// The commands of a path in absolute coordinates.
std::vector<Piece> parsed(std::string d) {
  for (const char c : std::string("MLCz-")) {
    const std::string from(1, c), to = c == '-' ? " -" : std::string(" ") + c + ' ';
    for (std::size_t at = 0; (at = d.find(from, at)) != std::string::npos; at += to.size()) d.replace(at, 1, to);
  }
  std::istringstream in(d);
  std::vector<Piece> pieces;
  for (std::string word; in >> word;)
    if (std::isalpha(static_cast<unsigned char>(word[0]))) {
      pieces.push_back({word[0], {}});
    } else {
      double y = 0;
      in >> y;
      pieces.back().points.push_back({std::stod(word), y});
    }
  return pieces;
}

TEST(Bezier, StraightLineIsOneLine) {
  PathData path;
  append_curve(
      path,
      [](double t) {
        return CurvePoint{{10 * t, 20 * t}, {10, 20}};
      },
      0, 3);
  EXPECT_EQ(path.str(), "L30 60");
}

TEST(Bezier, CubicIsReproducedByOneSegment) {
  const auto cubic = [](double t) { return CurvePoint{{90 * t, 60 * t * t * t}, {90, 180 * t * t}}; };
  PathData path;
  append_curve(path, cubic, 0, 1);
  EXPECT_EQ(path.str(), "C30 0 60 0 90 60");
}

TEST(Bezier, BackwardsEndsAtTheBeginning) {
  const auto parabola = [](double t) { return CurvePoint{{100 * t, 50 * t * t}, {100, 100 * t}}; };
  PathData path;
  append_curve(path, parabola, 1, 0);
  EXPECT_EQ(parsed(path.str()).back().points.back(), (Vec2{0, 0}));
}

TEST(Bezier, CircleStaysWithinATenthOfAPixel) {
  constexpr double radius = 400;
  PathData path;
  path.move_to({radius, 0});
  append_curve(
      path,
      [](double t) {
        return CurvePoint{radius * unit(t), radius * left_of(unit(t))};
      },
      0, 2 * pi);
  const auto pieces = parsed(path.str());
  ASSERT_GE(pieces.size(), 5u);
  EXPECT_LE(pieces.size(), 33u);
  Vec2 a = pieces[0].points[0];
  for (std::size_t i = 1; i < pieces.size(); ++i) {
    ASSERT_EQ(pieces[i].command, 'C');
    const auto& p = pieces[i].points;
    for (double s = 0; s <= 1; s += 0.0625) {
      const double r = 1 - s;
      const Vec2 x = r * r * r * a + 3 * r * r * s * p[0] + 3 * r * s * s * p[1] + s * s * s * p[2];
      EXPECT_NEAR(norm(x), radius, 0.1);
    }
    a = p[2];
  }
  EXPECT_EQ(a, (Vec2{radius, 0}));
}

}  // namespace

}  // namespace quadrille::draw
