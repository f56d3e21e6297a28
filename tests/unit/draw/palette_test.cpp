// Colours that must be told apart are, also as readers with other colour vision see them.
#include "draw/palette.hpp"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace quadrille::draw {

namespace {

using Channels = std::array<double, 3>;
using Matrix = std::array<Channels, 3>;

Channels times(const Matrix& m, const Channels& x) {
  Channels y{};
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) y[i] += m[i][j] * x[j];
  return y;
}

Channels linear_of(const std::string& colour) {
  Channels rgb{};
  for (int i = 0; i < 3; ++i) {
    const double c = std::stoi(colour.substr(1 + 2 * i, 2), nullptr, 16) / 255.0;
    rgb[i] = c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  }
  return rgb;
}

/// Ottosson 2020.
Channels oklab(const Channels& linear) {
  Channels lms = times({{{0.4122214708, 0.5363325363, 0.0514459929},
                         {0.2119034982, 0.6806995451, 0.1073969566},
                         {0.0883024619, 0.2817188376, 0.6299787005}}},
                       linear);
  for (double& x : lms) x = std::cbrt(x);
  return times({{{0.2104542553, 0.7936177850, -0.0040720468},
                 {1.9779984951, -2.4285922050, 0.4505937099},
                 {0.0259040371, 0.7827717662, -0.8086757660}}},
               lms);
}

/// On linear RGB, of complete protanopia, deuteranopia and tritanopia (Machado, Oliveira and Fernandes 2009, table 1);
/// the first is ordinary vision.
const std::array<Matrix, 4> visions{
    {{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
     {{{0.152286, 1.052583, -0.204868}, {0.114503, 0.786281, 0.099216}, {-0.003882, -0.048116, 1.051998}}},
     {{{0.367322, 0.860646, -0.227968}, {0.280085, 0.672501, 0.047413}, {-0.011820, 0.042940, 0.968881}}},
     {{{1.255528, -0.076749, -0.178779}, {-0.078411, 0.930809, 0.147602}, {0.004733, 0.691367, 0.303900}}}}};

Channels seen(const Matrix& vision, const std::string& colour) {
  Channels linear = times(vision, linear_of(colour));
  for (double& x : linear) x = std::clamp(x, 0.0, 1.0);
  return oklab(linear);
}

/// The least distance of two colours in OKLab with any vision; white and black are 1 apart.
double least_difference(const std::string& a, const std::string& b) {
  double least = 1;
  for (const Matrix& vision : visions) {
    const Channels p = seen(vision, a), q = seen(vision, b);
    least = std::min(least, std::hypot(p[0] - q[0], p[1] - q[1], p[2] - q[2]));
  }
  return least;
}

void expect_apart(const std::vector<std::string>& colours, double least) {
  for (std::size_t i = 0; i < colours.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      EXPECT_GT(least_difference(colours[i], colours[j]), least) << colours[i] << ' ' << colours[j];
}

TEST(Palette, TheMeasureOfDifferencesSeesWhatReadersWithoutRedAndGreenDoNot) {
  EXPECT_NEAR(least_difference("#000000", "#ffffff"), 1, 1e-3);
  const std::string red = "#b07a00", orange = "#d55e00";
  EXPECT_LT(least_difference(red, orange), 0.02);
}

TEST(Palette, LinesNodesAndContoursAreToldApartWithAnyColourVision) {
  for (const Paper paper : {Paper::light, Paper::dark}) {
    const Palette& colours = palette(paper);
    expect_apart({colours.few, colours.many, colours.other}, 0.1);
    expect_apart({colours.u_contour, colours.v_contour}, 0.1);
    expect_apart({colours.u_contour, colours.v_contour, colours.interface}, 0.1);
    expect_apart(colours.lines, 0.05);
  }
}

TEST(Palette, RampsGoOnWithAnyColourVision) {
  for (const Paper paper : {Paper::light, Paper::dark})
    for (const Ramp& ramp : {palette(paper).quality, palette(paper).amount})
      for (std::size_t i = 1; i < ramp.size(); ++i)
        EXPECT_GT(least_difference(ramp[i - 1].colour, ramp[i].colour), 0.04) << ramp[i].colour;
}

TEST(Palette, TheEndsOfARampAreFarApart) {
  for (const Paper paper : {Paper::light, Paper::dark})
    for (const Ramp& ramp : {palette(paper).quality, palette(paper).amount})
      EXPECT_GT(least_difference(ramp.front().colour, ramp.back().colour), 0.3);
}

TEST(Palette, CrossAngleIsPeriodicAndItsQuartersDifferWithAnyColourVision) {
  for (const Paper paper : {Paper::light, Paper::dark}) {
    const auto at = [&](double degrees) { return cross_angle_colour(paper, degrees, 1); };
    EXPECT_EQ(at(-45), at(45));
    EXPECT_EQ(cross_angle_colour(paper, -30, 0), cross_angle_colour(paper, 20, 0));
    expect_apart({at(-22.5), at(0), at(22.5), at(45)}, 0.06);
  }
}

TEST(Colour, GreysAreGreyAndEndsAreBlackAndWhite) {
  EXPECT_EQ(oklch(0, 0, 0), "#000000");
  EXPECT_EQ(oklch(1, 0, 0), "#ffffff");
  const std::string grey = oklch(0.6, 0, 123);
  EXPECT_EQ(grey.substr(1, 2), grey.substr(3, 2));
  EXPECT_EQ(grey.substr(1, 2), grey.substr(5, 2));
}

TEST(Colour, RampHitsItsStopsAndMixesBetween) {
  const Ramp ramp{{0, "#000000"}, {0.5, "#646464"}, {1, "#ffffff"}};
  EXPECT_EQ(ramp_colour(ramp, -1), "#000000");
  EXPECT_EQ(ramp_colour(ramp, 0.25), "#323232");
  EXPECT_EQ(ramp_colour(ramp, 0.5), "#646464");
  EXPECT_EQ(ramp_colour(ramp, 2), "#ffffff");
}

TEST(Colour, NeighboursDiffer) {
  for (int i = 0; i < 50; ++i) EXPECT_NE(quiet_colour(i), quiet_colour(i + 1));
}

}  // namespace

}  // namespace quadrille::draw
