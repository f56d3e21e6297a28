#pragma once
// Pictures in other formats than SVG, made by the program rsvg-convert (librsvg), which is started when it is needed:
// linking librsvg would make every start of a tool slower.

#include <string>

namespace quadrille::io {

enum class PictureFormat { svg, png, pdf };

/// By the ending of the path, ".png" or ".pdf"; else SVG.
PictureFormat picture_format(const std::string& path);

/// The SVG as PNG, one pixel for each of its pixels on white, or as PDF with lines and texts, without the time at which
/// it was made: the same bytes each time. Throws OutputError, with the name `path`, if rsvg-convert is not installed or
/// fails.
std::string converted_picture(const std::string& svg, PictureFormat format, const std::string& path);

}  // namespace quadrille::io
