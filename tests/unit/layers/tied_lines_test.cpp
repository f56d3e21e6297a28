#include "layers/tied_lines.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace quadrille::layers {
namespace {

/// Vertical lines 1 long, `gap` apart, of two elements of order 1; their middle nodes at these parameters.
LineNodes lines(const std::vector<double>& middle, double gap) {
  LineNodes nodes{static_cast<int>(middle.size()), 3, {}, {}};
  for (std::size_t line = 0; line < middle.size(); ++line)
    for (const double u : {0.0, middle[line], 1.0}) {
      nodes.parameters.push_back(u);
      nodes.positions.push_back({gap * static_cast<double>(line), u});
    }
  return nodes;
}

std::vector<double> middles(const LineNodes& nodes) {
  std::vector<double> result;
  for (int line = 0; line < nodes.num_lines; ++line) result.push_back(nodes.parameters[3 * line + 1]);
  return result;
}

void smooth_across(LineNodes& nodes) {
  const LineNodes given = nodes;
  layers::smooth_across(given, 1, 2, 1, 2, nodes.parameters);
}

TEST(SmoothAcross, EqualLinesStay) {
  LineNodes nodes = lines({0.4, 0.4, 0.4, 0.4}, 0.1);
  smooth_across(nodes);
  for (const double u : middles(nodes)) EXPECT_NEAR(u, 0.4, 1e-14);
}

TEST(SmoothAcross, OtherValuesOfTheNodesAreSmoothedAsParametersAre) {
  const LineNodes given = lines({0.4, 0.5, 0.45, 0.4}, 0.2);
  LineNodes smoothed = given;
  smooth_across(smoothed);
  std::vector<double> doubled;
  for (const double u : given.parameters) doubled.push_back(2 * u);
  layers::smooth_across(given, 1, 2, 1, 2, doubled);
  for (std::size_t i = 0; i < doubled.size(); ++i) EXPECT_NEAR(doubled[i], 2 * smoothed.parameters[i], 1e-14);
  EXPECT_GT(std::abs(smoothed.parameters[4] - 0.5), 1e-3) << "they change";
}

TEST(SmoothAcross, LinesFarFromEachOtherStay) {
  LineNodes nodes = lines({0.4, 0.7, 0.4, 0.6}, 1e4);
  smooth_across(nodes);
  EXPECT_NEAR(nodes.parameters[4], 0.7, 1e-6);
  EXPECT_NEAR(nodes.parameters[7], 0.4, 1e-6);
}

TEST(SmoothAcross, CloseLinesBecomeAlikeBetweenTheSides) {
  LineNodes nodes = lines({0.4, 0.42, 0.39, 0.4}, 1e-4);
  smooth_across(nodes);
  EXPECT_EQ(nodes.parameters[1], 0.4) << "sides do not move";
  EXPECT_EQ(nodes.parameters[10], 0.4);
  for (const double u : middles(nodes)) EXPECT_NEAR(u, 0.4, 1e-4);
  EXPECT_EQ(nodes.parameters[3], 0) << "nor do nodes outside the range";
}

TEST(SmoothAcross, LinesBesideASideThatIsDividedDifferentlyDoNotJump) {
  std::vector<double> middle(40, 0.5);
  middle.front() = middle.back() = 0.4;
  const double gap = 1e-3;
  LineNodes nodes = lines(middle, gap);
  smooth_across(nodes);
  const std::vector<double> found = middles(nodes);
  for (std::size_t line = 1; line < found.size(); ++line)
    EXPECT_LT(std::abs(found[line] - found[line - 1]), 0.01 * gap);
}

TEST(SmoothAcross, NoParameterLeavesTheRangeOfItsNodeAndMirrorImagesAgree) {
  const std::vector<double> middle{0.4, 0.7, 0.3, 0.6, 0.5};
  LineNodes nodes = lines(middle, 0.3), mirrored = lines({middle.rbegin(), middle.rend()}, 0.3);
  smooth_across(nodes);
  smooth_across(mirrored);
  const std::vector<double> found = middles(nodes);
  std::vector<double> turned = middles(mirrored);
  std::reverse(turned.begin(), turned.end());
  for (std::size_t line = 0; line < middle.size(); ++line) {
    EXPECT_GE(found[line], 0.3);
    EXPECT_LE(found[line], 0.7);
    EXPECT_NEAR(found[line], turned[line], 1e-14);
  }
  EXPECT_LT(found[1], 0.7);
  EXPECT_GT(found[2], 0.3);
}

}  // namespace
}  // namespace quadrille::layers
