#pragma once
// The frame of a page: positions as integers of 32 bits, whose step is the extent of everything drawn by 2^30.

#include <cstdint>
#include <vector>

#include "draw/picture.hpp"

namespace quadrille::page {

struct PageFrame {
  Vec2 centre;
  double step = 1;    ///< a length: one unit of the integers
  double extent = 1;  ///< greater side of the box, a length

  /// The nearest integer of the range; 0 for what is no number.
  std::int32_t quantised(double distance) const;
  void append(std::vector<std::int32_t>& to, Vec2 x) const;
};

/// The frame of a box; an empty one counts as the unit square, a point as a square of side 1 around it.
PageFrame page_frame(const draw::PictureBox& box);

}  // namespace quadrille::page
