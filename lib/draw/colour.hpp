#pragma once
// Colours of the pictures, made in OKLCH (Ottosson 2020): equal steps of lightness, chroma and hue look equal.

#include <string>
#include <vector>

namespace quadrille::draw {

/// "#rrggbb" of lightness in [0, 1], chroma in [0, 0.37] and hue in degrees; colours outside sRGB are clipped.
std::string oklch(double lightness, double chroma, double hue);

/// Colour `i` of an unlimited series of pale colours; consecutive ones are far apart in hue (golden angle).
std::string quiet_colour(int i);
/// The same hues, dark enough for lines.
std::string line_colour(int i);

/// A ramp through colours "#rrggbb" at rising positions from 0 to 1, linear in between.
struct ColourStop {
  double position;
  std::string colour;
};
using Ramp = std::vector<ColourStop>;

/// The colour of the ramp at t in [0, 1] (clamped).
std::string ramp_colour(const Ramp& ramp, double t);

/// Cross angle in degrees [-45, 45], periodic; grey towards |v| = 0, where the angle is undefined.
std::string cross_angle_colour(double degrees, double magnitude);

const Ramp& component_ramp();        ///< of u or v: t = (value + 1) / 2
const Ramp& order_ramp();            ///< of polynomial orders, low to high
const Ramp& scaled_jacobian_ramp();  ///< t = scaled Jacobian; warm is bad
Ramp cross_angle_ramp();             ///< t = degrees / 90 + 1/2, at full magnitude

}  // namespace quadrille::draw
