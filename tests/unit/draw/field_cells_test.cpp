#include "draw/field_cells.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "../region_samples.hpp"
#include "../support/square_field.hpp"
#include "draw/zero_contours.hpp"

namespace quadrille::draw {

namespace {

/// The square [-1, 1]^2 in 400 x 400 pixels.
struct SquarePicture : testing::Test {
  static DrawOptions options() {
    DrawOptions o;
    o.width = 472;
    return o;
  }
  Picture picture{{{-1, -1}, {1, 1}}, options(), "", ""};

  static Field field_of(int order, const std::function<Vec2(Vec2)>& value) {
    return interpolated_field(square_mesh({-1, -1}, 2, 3), order, value);
  }
  std::vector<Polyline> zeros_of_u(int order, const std::function<Vec2(Vec2)>& value) const {
    const Field field = field_of(order, value);
    return zero_contours(picture, field::FieldEvaluator(field), [](Vec2 v) { return v.x; });
  }
  static double length(const Polyline& line) {
    double sum = 0;
    for (std::size_t k = 1; k < line.size(); ++k) sum += distance(line[k - 1], line[k]);
    return sum;
  }
  int num_in_drawing(const std::string& part) const {
    const std::string svg = picture.str();
    int n = 0;
    for (std::size_t at = svg.find(part); at != std::string::npos; at = svg.find(part, at + 1)) ++n;
    return n;
  }
};

TEST_F(SquarePicture, AStraightContourIsOneLineFromSideToSide) {
  // u = 0 on x + 0.3 y = 0.1, across many elements.
  const auto lines = zeros_of_u(1, [](Vec2 x) { return Vec2{x.x + 0.3 * x.y - 0.1, 1}; });
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(length(lines[0]), 400 * std::sqrt(1.09), 0.1);
  for (const Vec2 p : lines[0]) {
    const Vec2 x = p / 200.0 - Vec2{1, 1};
    EXPECT_NEAR(x.x + 0.3 * x.y, 0.1, 1e-6);
  }
}

TEST_F(SquarePicture, AClosedContourClosesWithinAPixel) {
  const auto lines = zeros_of_u(2, [](Vec2 x) { return Vec2{norm2(x) - 0.49, 1}; });
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_LT(distance(lines[0].front(), lines[0].back()), 0.6);
  EXPECT_NEAR(length(lines[0]), 2 * pi * 0.7 * 200, 2);
}

TEST_F(SquarePicture, SeparateContoursAreSeparateLines) {
  EXPECT_EQ(zeros_of_u(2, [](Vec2 x) { return Vec2{(x.x - 0.4) * (x.x + 0.5), 1}; }).size(), 2u);
}

TEST_F(SquarePicture, WhereNothingChangesSignThereIsNone) {
  EXPECT_TRUE(zeros_of_u(2, [](Vec2 x) { return Vec2{norm2(x) + 0.1, 1}; }).empty());
  EXPECT_TRUE(zeros_of_u(1, [](Vec2) { return Vec2{0, 1}; }).empty()) << "zero everywhere";
  EXPECT_TRUE(zeros_of_u(1, [](Vec2 x) { return Vec2{1e-9 * x.x, 1}; }).empty()) << "noise";
}

TEST_F(SquarePicture, JumpsOfTheCrossAngleAreDashed) {
  // v = y: zero along the x axis; u = x is negative on its left half, where the angle jumps.
  const Field field = field_of(1, [](Vec2 x) { return x; });
  draw_zero_contours(picture, RegionFields(field));
  EXPECT_EQ(num_in_drawing("class=\"zero-u\""), 2);  // the line and its mark in the legend
  EXPECT_EQ(num_in_drawing("class=\"zero-v\""), 2);
  EXPECT_EQ(num_in_drawing("class=\"jump\""), 2);
}

TEST_F(SquarePicture, CellsAreSplitWhereTheValueChanges) {
  const Field field = field_of(1, [](Vec2 x) { return x; });
  const field::FieldEvaluator evaluator(field);
  const auto num_cells = [&](const std::function<double(Vec2, Vec2)>& difference) {
    Picture fresh({{-1, -1}, {1, 1}}, options(), "", "");
    draw_field_cells(
        fresh, evaluator, [](Vec2) { return std::string("#123456"); }, difference);
    const std::string svg = fresh.str();
    return std::count(svg.begin() + static_cast<std::ptrdiff_t>(svg.find("class=\"cells\"")), svg.end(), 'z');
  };
  // An element of 133 pixels and a diagonal of 189 is halved twice to be below 48 pixels.
  EXPECT_EQ(num_cells([](Vec2, Vec2) { return 0.0; }), 18 * 16);
  EXPECT_EQ(num_cells([](Vec2, Vec2) { return 2.0; }), 18 * 4096) << "down to 5 pixels";
  const auto at_axis = num_cells([](Vec2 a, Vec2 b) { return (a.x > 0) == (b.x > 0) ? 0.0 : 2.0; });
  EXPECT_GT(at_axis, 18 * 16);
  EXPECT_LT(at_axis, 18 * 1024);
}

/// Two of the six nodes of element 0 far away, as in damaged files.
Field folded(Field field, double far) {
  TriMesh& mesh = field.mesh;
  mesh.order = 2;
  mesh.curved_elems = {0};
  for (const Vec2 xi : spectral::tri_nodes(2)) mesh.curved_nodes.push_back(0.5 * xi);
  mesh.curved_nodes[1] = {far, far};
  mesh.curved_nodes[4] = {-0.3, -far};
  return field;
}

TEST_F(SquarePicture, CellsOfElementsThatLieFarOutsideEnd) {
  const Field sound = field_of(1, [](Vec2 x) { return x; });
  for (const double far : {1e3, 1e9, 1e128, 1e308}) {
    const Field field = folded(sound, far);
    Picture fresh({{-1, -1}, {1, 1}}, options(), "", "");
    const field::FieldEvaluator evaluator(field);
    draw_field_cells(
        fresh, evaluator, [](Vec2) { return std::string("#123456"); }, [](Vec2, Vec2) { return 0.0; });
    const std::string svg = fresh.str();
    const auto num_cells =
        std::count(svg.begin() + static_cast<std::ptrdiff_t>(svg.find("class=\"cells\"")), svg.end(), 'z');
    EXPECT_GE(num_cells, 17 * 16) << far;
    EXPECT_LT(num_cells, 17 * 16 + 100000) << far;
    for (const Polyline& line : zero_contours(fresh, evaluator, [](Vec2 v) { return v.x; }))
      for (const Vec2 p : line) EXPECT_TRUE(std::isfinite(p.x) && std::isfinite(p.y)) << far;
  }
}

TEST_F(SquarePicture, CellsOfOneColourAreOnePath) {
  const Field field = field_of(1, [](Vec2 x) { return x; });
  draw_field_cells(
      picture, field::FieldEvaluator(field), [](Vec2 v) { return v.x > 0 ? "#aaaaaa" : "#bbbbbb"; },
      [](Vec2, Vec2) { return 0.0; });
  EXPECT_EQ(num_in_drawing("fill=\"#aaaaaa\""), 1);
  EXPECT_EQ(num_in_drawing("fill=\"#bbbbbb\""), 1);
}

TEST_F(SquarePicture, CrossesThatFitStandOnALattice) {
  const Field field = field_of(1, [](Vec2) { return Vec2{1, 0}; });
  draw_crosses(picture, field::FieldEvaluator(field), 100);
  const std::string svg = picture.str();
  const std::size_t at = svg.find("class=\"cross\" d=\"");
  ASSERT_NE(at, std::string::npos);
  const std::string path = svg.substr(at, svg.find("/>", at) - at);
  EXPECT_EQ(std::count(path.begin(), path.end(), 'M'), 2 * 16);
}

TEST_F(SquarePicture, WhereTheFieldVanishesThereIsNoCross) {
  const Field field = field_of(1, [](Vec2) { return Vec2{0, 0}; });
  draw_crosses(picture, field::FieldEvaluator(field), 100);
  EXPECT_EQ(num_in_drawing("class=\"cross\""), 0);
}

TEST(RegionFields, LiftingsHoldInTheirOwnRegion) {
  Field field = samples::two_regions_field();
  field.liftings = {{4, {1, 0}, {0.5, -0.5}, {1, 0}}};  // of a joint of the right square
  const RegionFields regions(field);
  ASSERT_EQ(regions.evaluators.size(), 2u);
  Vec2 value;
  ASSERT_TRUE(regions.evaluators[0].value_at({0.5, 0.3}, value));
  EXPECT_NEAR(distance(value, {1, 0}), 0, 1e-12);
  ASSERT_TRUE(regions.evaluators[1].value_at({1.5, 0.3}, value));
  EXPECT_GT(distance(value, {1, 0}), 0.1);
  EXPECT_FALSE(regions.evaluators[0].value_at({1.5, 0.3}, value));
}

TEST(RegionFields, OneRegionIsTheField) {
  const Field field = samples::field();
  const RegionFields regions(field);
  ASSERT_EQ(regions.evaluators.size(), 1u);
  EXPECT_EQ(regions.fields[0].u, field.u);
}

TEST(RegionFields, EachRegionHasItsOwnPhase) {
  const RegionFields regions(samples::two_regions_phase_field());
  Vec2 value;
  ASSERT_TRUE(regions.evaluators[1].value_at({1.5, 0.3}, value));
  EXPECT_NEAR(distance(value, {1, 0}), 0, 1e-12) << "no terms, s = 0";
  ASSERT_TRUE(regions.evaluators[0].value_at({0.5, 0.3}, value));
  EXPECT_GT(distance(value, {1, 0}), 0.1);
}

}  // namespace

}  // namespace quadrille::draw
