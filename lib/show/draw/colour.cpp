#include "draw/colour.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "base/angle.hpp"

namespace quadrille::draw {

namespace {

int channel(double linear) {
  const double c = std::clamp(linear, 0.0, 1.0);
  const double encoded = c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055;
  return static_cast<int>(std::lround(255 * encoded));
}

std::array<int, 3> channels(const std::string& colour) {
  const int rgb = std::stoi(colour.substr(1), nullptr, 16);
  return {rgb >> 16, rgb >> 8 & 255, rgb & 255};
}

constexpr double golden_angle = 137.50776405003785;

}  // namespace

std::string oklch(double lightness, double chroma, double hue) {
  const double a = chroma * std::cos(radians(hue)), b = chroma * std::sin(radians(hue));
  const double l = std::pow(lightness + 0.3963377774 * a + 0.2158037573 * b, 3);
  const double m = std::pow(lightness - 0.1055613458 * a - 0.0638541728 * b, 3);
  const double s = std::pow(lightness - 0.0894841775 * a - 1.2914855480 * b, 3);
  return fmt::format("#{:02x}{:02x}{:02x}", channel(4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s),
                     channel(-1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s),
                     channel(-0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s));
}

double quiet_hue(int i) { return 230 + golden_angle * i; }

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
