#pragma once
// The colours of what is drawn: pictures use those for light paper, pages (lib/show/page) both. No other place has
// them.
//
// Lines, nodes and contours have colours of Okabe and Ito ("Color Universal Design", 2008), which readers with any
// kind of colour vision tell apart; the sixth is darker, the eighth is left out, as yellow is not seen on white. Ramps
// differ in lightness or run from warm to cold. tests/unit/draw/palette_test.cpp measures the differences as seen with
// protanopia, deuteranopia and tritanopia (Machado, Oliveira and Fernandes 2009). Other colours are made in OKLCH
// (Ottosson 2020): equal steps of lightness, chroma and hue look equal.

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

enum class Paper { light, dark };

struct Palette {
  Ramp quality;                      ///< 0: bad, 1: good
  Ramp amount;                       ///< of figures that are neither: low to high
  std::vector<std::string> blocks;   ///< areas without a figure, in turn
  std::vector<std::string> lines;    ///< in turn
  std::string few, many, other;      ///< nodes with one block less or more than regular ones, and all others
  std::string u_contour, v_contour;  ///< lines u = 0 and v = 0
  std::string interface;             ///< curves in which two regions meet
};

const Palette& palette(Paper paper);

/// Light, blue, dark, orange and back: the cross angle in degrees [-45, 45], periodic; grey towards |v| = 0, where it
/// is undefined.
std::string cross_angle_colour(Paper paper, double degrees, double magnitude);

/// The angle at full magnitude: t = degrees / 90 + 1/2.
Ramp cross_angle_ramp(Paper paper);

}  // namespace quadrille::draw
