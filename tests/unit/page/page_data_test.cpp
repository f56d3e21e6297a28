#include "page/page_data.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <limits>

#include "base/base64.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::page {

namespace {

TEST(PageData, NumbersArePackedWithTheirLowByteFirst) {
  EXPECT_EQ(packed(std::vector<std::int32_t>{1, -2}), base64(std::string("\1\0\0\0\xfe\xff\xff\xff", 8)));
  EXPECT_EQ(packed(std::vector<std::int16_t>{258, -1}), base64("\2\1\xff\xff"));
  EXPECT_EQ(packed(std::vector<std::uint8_t>{7, 255}), base64("\7\xff"));
  EXPECT_EQ(packed_floats({1.0}), base64(std::string("\0\0\x80\x3f", 4)));
}

TEST(PageData, TextsCannotEndAScriptNorOpenMarkup) {
  EXPECT_EQ(script_string("a\"b</script>&\n"), R"("a\"b\u003c/script\u003e\u0026\u000a")");
  EXPECT_EQ(html_text("<b a=\"1\">&\n"), "&lt;b a=&quot;1&quot;&gt;&amp; ");
}

TEST(PageData, ObjectsKeepTheOrderOfTheirKeys) {
  JsonObject object;
  object.text("b", "x").number("a", 0.5).flag("c", true).number("d", std::numeric_limits<double>::infinity());
  object.json("e", json_list({"1", "2"})).data("f", "Zg==").json("g", json_texts({"<"}));
  EXPECT_EQ(object.str(), R"({"b":"x","a":0.5,"c":true,"d":null,"e":[1,2],"f":"Zg==","g":["\u003c"]})");
}

/// A circular arc of the angle `turn`, as samples of a side.
SideSamples arc(double turn) {
  SideSamples samples;
  for (int k = 0; k <= 8; ++k) samples[k] = {unit(turn * k / 8), turn * left_of(unit(turn * k / 8))};
  return samples;
}

Vec2 cubic_point(const std::array<Vec2, 4>& c, double s) {
  const double r = 1 - s;
  return r * r * r * c[0] + 3 * r * r * s * c[1] + 3 * r * s * s * c[2] + s * s * s * c[3];
}

/// The greatest distance of the stored pieces from the unit circle.
double distance_from_circle(const Bends& bends, const SideSamples& side) {
  using Complex = std::complex<double>;
  const Vec2 a = side.front().position, b = side.back().position;
  std::vector<Vec2> points{a};
  for (std::size_t k = 0; k + 1 < bends.points.size(); k += 2) {
    const Complex z = Complex(bends.points[k], bends.points[k + 1]) / 8192.0 * Complex(b.x - a.x, b.y - a.y);
    points.push_back(a + Vec2{z.real(), z.imag()});
  }
  points.push_back(b);
  double greatest = 0;
  for (std::size_t i = 0; i + 3 < points.size(); i += 3)
    for (int k = 0; k <= 16; ++k)
      greatest =
          std::max(greatest,
                   std::abs(norm(cubic_point({points[i], points[i + 1], points[i + 2], points[i + 3]}, k / 16.0)) - 1));
  return greatest;
}

TEST(Bends, StraightSidesNeedNoPoints) {
  SideSamples side;
  for (int k = 0; k <= 8; ++k) side[k] = {Vec2{k / 8.0, 1 + k / 4.0}, Vec2{1, 2}};
  Bends bends;
  bends.append(side);
  EXPECT_EQ(bends.pieces, (std::vector<std::uint8_t>{0}));
  EXPECT_TRUE(bends.points.empty());
}

TEST(Bends, CurvedSidesAreExactToAFractionOfTheirChord) {
  for (const double turn : {0.02, 0.3, 1.0, 2.0, 3.0}) {
    Bends bends;
    bends.append(arc(turn));
    ASSERT_GE(bends.pieces[0], 1) << turn;
    EXPECT_EQ(bends.points.size(), 6u * bends.pieces[0] - 2u) << turn;
    EXPECT_LT(distance_from_circle(bends, arc(turn)), 5e-4 * 2 * std::sin(turn / 2)) << turn;
  }
}

TEST(Bends, StrongBendsTakeMorePieces) {
  Bends bends;
  for (const double turn : {0.5, 2.5}) bends.append(arc(turn));
  EXPECT_LT(bends.pieces[0], bends.pieces[1]);
}

TEST(Bends, ASideThatEndsWhereItBeginsHasNoPieces) {
  SideSamples side{};
  Bends bends;
  bends.append(side);
  EXPECT_EQ(bends.pieces[0], 0);
}

TEST(Chains, PiecesOfCurvesAreJoinedInTheirDirection) {
  const PageFrame frame = page_frame({{-1, -1}, {1, 1}});
  const std::vector<Nurbs> curves{curve::circular_arc({0, 0}, 1, 0, 2), curve::segment(unit(2), {0, 0})};
  Chains chains;
  chains.append(frame, {{0, curves[0].begin(), curves[0].end()}, {1, 0, 1}},
                [&](int id) -> const Nurbs& { return curves[id]; });
  chains.append_piece(frame, curves[1], 1, 0);
  chains.close_chain();
  ASSERT_EQ(chains.offsets.size(), 3u);
  const auto at = [&](int k) {
    return frame.step * Vec2{double(chains.points[2 * k]), double(chains.points[2 * k + 1])};
  };
  const int end = chains.offsets[1];
  EXPECT_EQ((end - 1) % 3, 0);
  EXPECT_NEAR(distance(at(0), {1, 0}), 0, 1e-8);
  EXPECT_NEAR(norm(at(end - 1)), 0, 1e-8);
  EXPECT_NEAR(norm(at(end)), 0, 1e-8);
  EXPECT_NEAR(distance(at(chains.offsets[2] - 1), unit(2)), 0, 1e-8);
  for (int k = 0; k + 6 < end; k += 3)
    EXPECT_NEAR(norm(cubic_point({at(k), at(k + 1), at(k + 2), at(k + 3)}, 0.3)), 1, 5e-6);
}

TEST(PageFrame, PositionsAreExactToTheBillionthPartOfTheExtent) {
  const PageFrame frame = page_frame({{100, 200}, {104, 201}});
  std::vector<std::int32_t> q;
  frame.append(q, {103.3, 200.7});
  EXPECT_NEAR(frame.centre.x + q[0] * frame.step, 103.3, 4e-9);
  EXPECT_NEAR(frame.centre.y + q[1] * frame.step, 200.7, 4e-9);
  EXPECT_EQ(frame.quantised(1e300), 2147483647);
  EXPECT_EQ(frame.quantised(std::nan("")), 0);
  EXPECT_EQ(page_frame(draw::PictureBox()).extent, 1);
  EXPECT_EQ(page_frame({{2, 2}, {2, 2}}).extent, 1);
}

}  // namespace

}  // namespace quadrille::page
