#include "draw/palette.hpp"

#include <algorithm>
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

}  // namespace

const Palette& palette(Paper paper) {
  static const Palette light = on_light(), dark = on_dark();
  return paper == Paper::light ? light : dark;
}

std::string cross_angle_colour(Paper paper, double degrees, double magnitude) {
  constexpr double blue = 250, orange = 60;
  const bool is_light = paper == Paper::light;
  const double phase = radians(4 * degrees), side = std::sin(phase);
  const double lightness = (is_light ? 0.86 : 0.45) + (is_light ? 0.07 : 0.09) * std::cos(phase);
  const std::string full = oklch(lightness, 0.1 * std::abs(side), side > 0 ? blue : orange);
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

}  // namespace quadrille::draw
