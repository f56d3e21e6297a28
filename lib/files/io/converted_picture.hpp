#pragma once
// Pictures in other formats than SVG, made by the program rsvg-convert (librsvg), which is started when it is needed:
// linking librsvg would make every start of a tool slower.

#include <string>

namespace quadrille::io {

enum class PictureFormat { svg, png, pdf };

/// What follows the last dot of a file's name, in small letters: "png" of "a.b/c.PNG", "" of "c" and "-".
std::string picture_ending(const std::string& path);

/// By the ending of the path: svg, png or pdf; without one SVG. Throws UsageError for another ending: a file that is
/// called x.gif and holds an SVG helps nobody.
PictureFormat picture_format(const std::string& path);

/// The SVG as PNG, one pixel for each of its pixels on white, or as PDF with lines and texts, without the time at which
/// it was made: the same bytes each time. Throws OutputError, with the name `path`, if rsvg-convert is not installed or
/// fails.
std::string converted_picture(const std::string& svg, PictureFormat format, const std::string& path);

}  // namespace quadrille::io
