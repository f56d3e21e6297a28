#include "draw/zero_contours.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../support/square_field.hpp"
#include "base/angle.hpp"
#include "draw/field_cells.hpp"

namespace quadrille::draw {

namespace {

/// The square [-1, 1]^2 in 400 x 400 pixels, in 2 n^2 elements.
struct SquareContour : testing::Test {
  static DrawOptions options() {
    DrawOptions o;
    o.width = 472;
    return o;
  }
  Picture picture{{{-1, -1}, {1, 1}}, options(), "", ""};

  static Field field_of(int n, int order, const std::function<Vec2(Vec2)>& value) {
    return interpolated_field(square_mesh({-1, -1}, 2, n), order, value);
  }
  static double u(Vec2 value) { return value.x; }

  static bool is_on_boundary(Vec2 p) { return std::min({p.x, p.y, 400 - p.x, 400 - p.y}) < 0.5; }
  /// Ends of lines inside the square that are at no other line.
  static int num_loose_ends(const std::vector<Polyline>& lines) {
    int num_loose = 0;
    for (std::size_t i = 0; i < lines.size(); ++i)
      for (const Vec2 end : {lines[i].front(), lines[i].back()}) {
        int num_near = 0;
        for (const Polyline& line : lines)
          num_near +=
              static_cast<int>(std::count_if(line.begin(), line.end(), [&](Vec2 p) { return distance(p, end) < 0.6; }));
        if (num_near < 2 && !is_on_boundary(end)) ++num_loose;
      }
    return num_loose;
  }
  static double length(const std::vector<Polyline>& lines) {
    double sum = 0;
    for (const Polyline& line : lines)
      for (std::size_t k = 1; k < line.size(); ++k) sum += distance(line[k - 1], line[k]);
    return sum;
  }
};

TEST_F(SquareContour, AContourThatLiesOnSidesOfElementsIsDrawn) {
  // The sides at x = 0 are sides of elements; the small constant makes u negative on both ends of some of them.
  for (const double rounding : {0.0, 1e-9, -1e-9, 1e-12, -1e-12}) {
    const Field field = field_of(4, 1, [&](Vec2 x) { return Vec2{x.x + rounding, 1}; });
    const auto lines = zero_contours(picture, field::FieldEvaluator(field), u);
    EXPECT_NEAR(length(lines), 400, 1) << rounding;
    EXPECT_EQ(num_loose_ends(lines), 0) << rounding;
  }
}

TEST_F(SquareContour, AJumpFromOneElementToTheNextIsPartOfTheContour) {
  // u = x - 0.2 y + 0.1 sign(x): on the sides at x = 0 it changes its sign without being zero in any element.
  const Field field = field_of(4, 1, [](Vec2 x) { return Vec2{x.x - 0.2 * x.y, 1}; });
  Field jumping = field;
  for (int e = 0; e < jumping.mesh.num_elems(); ++e) {
    double x = 0;
    for (const int v : jumping.mesh.elem2vertices[e]) x += jumping.mesh.vertices[v].x / 3;
    jumping.u[static_cast<std::size_t>(jumping.coef_offsets[e])] += (x > 0 ? 0.1 : -0.1) * std::sqrt(2.0);
  }
  const auto lines = zero_contours(picture, field::FieldEvaluator(jumping), u);
  EXPECT_EQ(num_loose_ends(lines), 0);
  // Along x = 0 while |y| < 0.5, then parallel to the contour without jump.
  EXPECT_NEAR(length(lines), 200 + 200 * std::sqrt(1.04), 2);
}

TEST_F(SquareContour, ContoursMeetAtAZeroOfHighOrder) {
  // Near the centre |u| = r^6 is below the noise; the twelve rays are drawn to the centre nevertheless.
  const Field field = field_of(2, 6, [](Vec2 x) { return Vec2{std::pow(norm(x), 6) * std::cos(6 * angle_of(x)), 1}; });
  const auto lines = zero_contours(picture, field::FieldEvaluator(field), u);
  EXPECT_EQ(num_loose_ends(lines), 0);
  double nearest = 400;
  for (const Polyline& line : lines)
    for (const Vec2 p : line) nearest = std::min(nearest, distance(p, {200, 200}));
  EXPECT_LT(nearest, 6);
}

TEST_F(SquareContour, PointsAreExactZerosWhereTheComponentIsCurved) {
  const Field field = field_of(2, 4, [](Vec2 x) { return Vec2{std::pow(x.x, 4) - 0.1, 1}; });
  for (const Polyline& line : zero_contours(picture, field::FieldEvaluator(field), u))
    for (const Vec2 p : line) EXPECT_NEAR(std::abs(p.x / 200 - 1), std::pow(0.1, 0.25), 1e-5);
}

TEST_F(SquareContour, OfAWindowIsTheSameContourWithoutWhatIsOutside) {
  const Field field = field_of(4, 2, [](Vec2 x) { return Vec2{norm2(x) - 0.7, 1}; });
  const field::FieldEvaluator evaluator(field);
  DrawOptions window = options();
  window.window = Window{{0, 0}, {1, 1}};
  const Picture part({{0, 0}, {1, 1}}, window, "", "");
  const double quarter = 400 * std::sqrt(0.7) * half_pi, shown = length(zero_contours(part, evaluator, u));
  EXPECT_GT(shown, quarter - 1);
  EXPECT_LT(shown, 2.5 * quarter) << "elements at the rim of the window are drawn, not those beyond";
  const Picture none({{0, 0}, {0.2, 0.2}}, window, "", "");
  EXPECT_TRUE(zero_contours(none, evaluator, u).empty());
}

TEST(SideSigns, ChangeAtEachRoot) {
  const SideSigns signs{true, {0.25, 0.5}, {true, false, true, true}};
  EXPECT_TRUE(signs.is_positive_at(0.1));
  EXPECT_FALSE(signs.is_positive_at(0.3));
  EXPECT_TRUE(signs.is_positive_at(0.9));
  EXPECT_TRUE(signs.is_significant_at(0));
  EXPECT_FALSE(signs.is_significant_at(0.3));
  EXPECT_TRUE(signs.is_significant_at(1));
}

}  // namespace

}  // namespace quadrille::draw
