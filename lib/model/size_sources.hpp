#pragma once
// Places that ask for a size of elements (formats/size-field.md), as people give them.
//
// Positions are relative to face.origin, lengths in the unit of the file.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

/// Edges of length `size` at `position` and as far as `radius` around it.
struct SizePoint {
  Vec2 position;
  double size = 0;
  double radius = 0;
};

/// Edges of length `size` in the rectangle with sides along the axes.
struct SizeBox {
  Vec2 low, high;
  double size = 0;
};

struct SizeSources {
  std::vector<SizePoint> points;
  std::vector<SizeBox> boxes;
  double growth = 0;  ///< from one element to the next, > 1; 0: not said
};

}  // namespace quadrille
