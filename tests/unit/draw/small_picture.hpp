#pragma once
// A picture in which tests can tell positions by heart.

#include "draw/picture.hpp"

namespace quadrille::draw {

/// The square from -1 to 1 in both directions, ten pixels per unit.
inline Picture small_picture() {
  DrawOptions options;
  options.width = 72 + 20;
  return {{{-1, -1}, {1, 1}}, options, "", ""};
}

}  // namespace quadrille::draw
