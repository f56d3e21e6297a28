#include "layers/normal_line.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "../hand_made.hpp"
#include "base/error.hpp"

namespace quadrille::layers {
namespace {

TEST(NormalLine, FindsHeightsAboveACircleAlongASlantedLine) {
  const CadFace face = hand_made::cut_annulus(1).face;  // curve 0: radius 1
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const Nurbs& circle = face.curves[0];
  const WallLine wall(table, {{0, circle.begin(), circle.end()}});
  const NormalLine line = [](double u) { return Vec2{1 - 0.8 * u, 0.3 * u}; };
  const std::vector<double> heights = node_heights({1e-6, 1e-3, 0.1}, 4);
  EXPECT_EQ(heights.size(), 12u);
  EXPECT_EQ(heights[3], 1e-6);
  EXPECT_EQ(heights.back(), 0.1);
  const std::vector<double> u = parameters_at_heights(line, wall, {0, circle.begin()}, heights);
  ASSERT_EQ(u.size(), heights.size());
  for (std::size_t k = 0; k < u.size(); ++k) EXPECT_NEAR(1 - norm(line(u[k])), heights[k], 1e-10 * heights[k] + 1e-15);
}

TEST(NormalLine, EndsWhereTheLineTurnsBack) {
  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table(face, none);
  const WallLine wall(table, {{0, 0, 1}});
  const NormalLine line = [](double u) { return Vec2{0.5 + 0.2 * u, 4 * u * (1 - u) * 0.3}; };
  EXPECT_EQ(parameters_at_heights(line, wall, {0, 0.5}, {0.1, 0.2, 0.29, 0.31, 0.4}).size(), 3u);
}

/// Lines between the lower and the upper side of the unit square, with the layers given for each.
class BetweenSides {
 public:
  BetweenSides(std::vector<double> low_layers, std::vector<double> high_layers)
      : low(side(bottom, std::move(low_layers))), high(side(top, std::move(high_layers))) {}

  std::vector<double> divide(const NormalLine& line, const std::vector<double>& left, const std::vector<double>& right,
                             double blend, int order = 1) const {
    const LineFamily family{low, high, left, right, order};
    CadFace of_file;
    of_file.origin = {100, 200};
    return divide_normal_line(family, line, 0, of_file, measured_line(family, line, 0, {blend, blend}, of_file).sizes);
  }

  BlockLine measure(const NormalLine& line, const std::vector<double>& left, const std::vector<double>& right,
                    const std::array<double, 2>& blend) const {
    return measured_line(LineFamily{low, high, left, right, 1}, line, 0, blend, {});
  }

 private:
  static SideLayers side(const WallLine& wall, std::vector<double> layers) {
    if (layers.empty()) return {};
    return {&wall, std::move(layers), {{0, 0.5}}};
  }

  const CadFace face = hand_made::unit_square().face;
  const std::vector<Nurbs> none;
  const curve::CurveTable table{face, none};
  const WallLine bottom{table, {{0, 0, 1}}}, top{table, {{2, 0, 1}}};
  const SideLayers low, high;
};

Vec2 upright(double u) { return {0.5, u}; }

void expect_near(const std::vector<double>& a, const std::vector<double>& b) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t k = 0; k < a.size(); ++k) EXPECT_NEAR(a[k], b[k], 1e-9) << k;
}

TEST(DivideNormalLine, PutsLayersAtTheirHeightsAtBothEnds) {
  const BetweenSides both({0.1, 0.3}, {0.2});
  const std::vector<double> beside{0.1, 0.2, 0.5, 0.2};
  expect_near(both.divide(upright, beside, beside, 0.3), {0, 0.1, 0.3, 0.8, 1});
}

TEST(DivideNormalLine, CoincidesWithTheArcsBesideItAtBothBlends) {
  const BetweenSides lower({0.1}, {});
  const std::vector<double> left{0.1, 0.2, 0.3, 0.4}, right{0.1, 0.3, 0.3, 0.3};
  expect_near(lower.divide(upright, left, right, 0), {0, 0.1, 0.3, 0.6, 1});
  expect_near(lower.divide(upright, left, right, 1), {0, 0.1, 0.4, 0.7, 1});
  const double middle = lower.divide(upright, left, right, 0.5)[2];
  EXPECT_GT(middle, 0.3);
  EXPECT_LT(middle, 0.4);
}

TEST(DivideNormalLine, StretchesIntervalsAboveTheLayersByOneFactor) {
  // The arcs beside the line are half as long above the layers.
  const BetweenSides lower({0.1}, {});
  const std::vector<double> beside{0.1, 0.05, 0.1, 0.3};
  expect_near(lower.divide(upright, beside, beside, 0.5), {0, 0.1, 0.2, 0.4, 1});
}

TEST(DivideNormalLine, PlacesGaussLobattoPointsOfEachElement) {
  const BetweenSides lower({0.1}, {});
  expect_near(lower.divide(upright, {0.1, 0.9}, {0.1, 0.9}, 0.5, 2), {0, 0.05, 0.1, 0.55, 1});
}

// Rule 9 of layer_rules.
// One line crosses two blocks and is a quarter of the way from left to right where it enters the first, three quarters
// where it leaves the second: its sizes do not jump between them, though the arcs beside it differ by a factor of 100.
TEST(MeasuredLine, SizesOfALineThatCrossesTwoBlocksContinueEachOther) {
  const BetweenSides free({}, {});
  const std::vector<double> left(50, 0.02), right(50, 0.0002);
  const BlockLine first = free.measure(upright, left, right, {0.25, 0.5});
  const BlockLine second = free.measure(upright, left, right, {0.5, 0.75});
  EXPECT_NEAR(first.sizes.front(), 0.02 * std::pow(0.01, 0.25), 1e-4);
  EXPECT_NEAR(second.sizes.back(), 0.02 * std::pow(0.01, 0.75), 1e-4);
  const double jump = first.sizes.back() / second.sizes.front();
  EXPECT_NEAR(jump, first.sizes[48] / first.sizes[49], 1e-3);
  EXPECT_LT(jump, 1.03);
}

TEST(DivideNormalLine, RefusesALineThatTurnsBackWithItsPlace) {
  const BetweenSides lower({0.1, 0.2}, {});
  const NormalLine arch = [](double u) { return Vec2{0.5, 0.6 * u * (1 - u)}; };
  try {
    lower.divide(arch, {0.1, 0.1, 0.1}, {0.1, 0.1, 0.1}, 0.5);
    FAIL() << "the line reaches 0.15 only";
  } catch (const ComputeError& error) {
    EXPECT_NE(std::string(error.what()).find("(100.5, 200)"), std::string::npos) << error.what();
  }
}

// Rule 9 with rule 12.
TEST(DivideNormalLine, RefusesLayersOfBothEndsThatOverlap) {
  const BetweenSides both({0.6}, {0.5});
  EXPECT_THROW(both.divide(upright, {0.6, 0.1, 0.5}, {0.6, 0.1, 0.5}, 0.5), ComputeError);
}

}  // namespace
}  // namespace quadrille::layers
