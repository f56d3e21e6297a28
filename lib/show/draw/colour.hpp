#pragma once
// Colours of the pictures, made in OKLCH (Ottosson 2020): equal steps of lightness, chroma and hue look equal.

#include <string>
#include <vector>

namespace quadrille::draw {

/// "#rrggbb" of lightness in [0, 1], chroma in [0, 0.37] and hue in degrees; colours outside sRGB are clipped.
std::string oklch(double lightness, double chroma, double hue);

/// Colour `i` of an unlimited series of pale colours; consecutive ones are far apart in hue (golden angle).
std::string quiet_colour(int i);
double quiet_hue(int i);  ///< its hue in degrees

/// The tint of a region; `shade` distinguishes areas of one region.
std::string region_colour(int region, int shade = 0);

/// A ramp through colours "#rrggbb" at rising positions from 0 to 1, linear in between.
struct ColourStop {
  double position;
  std::string colour;
};
using Ramp = std::vector<ColourStop>;

/// The colour of the ramp at t in [0, 1] (clamped).
std::string ramp_colour(const Ramp& ramp, double t);

const Ramp& component_ramp();  ///< of u or v: t = (value + 1) / 2

}  // namespace quadrille::draw
