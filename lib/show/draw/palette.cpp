#include "draw/palette.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::draw {

namespace {

constexpr int num_areas = 7;

/// Evenly spaced stops.
Ramp even_ramp(const std::vector<std::string>& colours) {
  Ramp ramp;
  for (std::size_t i = 0; i < colours.size(); ++i)
    ramp.push_back({static_cast<double>(i) / static_cast<double>(colours.size() - 1), colours[i]});
  return ramp;
}

Palette on_light() {
  Palette palette;
  palette.quality = {{0, "#a3262c"},    {0.25, "#dc6a4b"}, {0.5, "#f4b98f"},
                     {0.75, "#f5ead6"}, {0.9, "#d3e5ea"},  {1, "#a5cbdd"}};
  palette.amount = even_ramp({"#f6f3e4", "#cfe3cf", "#9fd0cd", "#74a9d0", "#5a6db0"});
  for (int i = 0; i < num_areas; ++i) palette.blocks.push_back(quiet_colour(i));
  palette.lines = {"#0072b2", "#d55e00", "#009e73", "#cc79a7", "#56b4e9", "#8a6100", "#6d3d96"};
  palette.few = "#0072b2";
  palette.many = "#d55e00";
  palette.other = "#333333";
  palette.u_contour = "#1f5f9e";
  palette.v_contour = "#b03a2e";
  palette.interface = "#b8860b";
  return palette;
}

Palette on_dark() {
  Palette palette;
  palette.quality = even_ramp({"#fdf3a0", "#a5d86c", "#3fae86", "#2f7d95", "#2c5072", "#223248"});
  palette.amount = even_ramp({"#223248", "#2c5072", "#2f7d95", "#3fae86", "#a5d86c"});
  for (int i = 0; i < num_areas; ++i) palette.blocks.push_back(oklch(0.34 + 0.025 * (i % 3), 0.045, quiet_hue(i)));
  palette.lines = {"#56b4e9", "#d55e00", "#009e73", "#cc79a7", "#0072b2", "#f0e442", "#e69f00"};
  palette.few = "#56b4e9";
  palette.many = "#e69f00";
  palette.other = "#f0f0f0";
  palette.u_contour = "#56b4e9";
  palette.v_contour = "#e8804a";
  palette.interface = "#f0e442";
  return palette;
}

int channel(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * encoded));
}

std::array<int, 3> channels(const std::string& colour) {
  const int rgb = std::stoi(colour.substr(1), nullptr, 16);
  return {rgb >> 16, rgb >> 8 & 255, rgb & 255};
}

}  // namespace

const Palette& palette(Paper paper) {
  static const Palette light = on_light(), dark = on_dark();
  return paper == Paper::light ? light : dark;
}

std::string cross_angle_colour(Paper paper, double degrees, double magnitude) {
  const bool is_light = paper == Paper::light;
  const double phase = radians(4 * degrees), side = std::sin(phase);
  const double lightness = (is_light ? 0.86 : 0.45) + (is_light ? 0.07 : 0.09) * std::cos(phase);
  // Blue or orange.
  const std::string full = oklch(lightness, 0.1 * std::abs(side), side > 0 ? 250 : 60);
  const Ramp fade{{0, is_light ? "#ececec" : "#343a42"}, {1, full}};
  return ramp_colour(fade, std::sqrt(std::clamp(magnitude, 0.0, 1.0)));
}

Ramp cross_angle_ramp(Paper paper) {
  constexpr int num_stops = 36;
  Ramp ramp;
  for (int i = 0; i <= num_stops; ++i)
    ramp.push_back({static_cast<double>(i) / num_stops, cross_angle_colour(paper, 90.0 * i / num_stops - 45, 1)});
  return ramp;
}

std::string oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(radians(hue)), b = chroma * std::sin(radians(hue));
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return fmt::format("#{:02x}{:02x}{:02x}", channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                     channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                     channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

double quiet_hue(int i) { return 230 + 137.50776405003785 * i; }

std::string quiet_colour(int i) { return oklch(0.92 - 0.025 * (i % 3), 0.045, quiet_hue(i)); }

std::string region_colour(int region, int shade) {
  return oklch(0.93 - 0.02 * (region % 2) - 0.025 * (shade % 3), 0.05, quiet_hue(region));
}

std::string ramp_colour(const Ramp& ramp, double t) {
  t = std::clamp(t, 0.0, 1.0);
  std::size_t i = 1;
  while (i + 1 < ramp.size() && ramp[i].position < t) ++i;
  const double width = ramp[i].position - ramp[i - 1].position;
  const double s = (t - ramp[i - 1].position) / width;
  const auto a = channels(ramp[i - 1].colour), b = channels(ramp[i].colour);
  const auto mix = [&](int k) { return static_cast<int>(std::lround(a[k] + s * (b[k] - a[k]))); };
  return fmt::format("#{:02x}{:02x}{:02x}", mix(0), mix(1), mix(2));
}

const Ramp& component_ramp() {
  static const Ramp ramp{{0, "#3a6fa8"}, {0.25, "#93b9dc"}, {0.5, "#f8f7f3"}, {0.75, "#ecb48f"}, {1, "#b9552f"}};
  return ramp;
}

}  // namespace quadrille::draw
