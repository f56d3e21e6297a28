#pragma once
// Pictures as parts of others.

#include <string>

namespace quadrille::draw {

/// A picture as a part of another: placed, and with identifiers of its own. Texts contain no quotation mark (svg.hpp).
std::string embedded(const std::string& svg, const std::string& prefix, double x);

/// The height that Picture::str wrote into the root element, pixels.
double height_of(const std::string& svg);

/// The root element and the white paper of a picture of parts, without its end tag.
std::string begin_parts(const std::string& title, int width, double height);

}  // namespace quadrille::draw
