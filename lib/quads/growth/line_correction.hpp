#pragma once
// Corrections of the intervals of a line of nodes that crosses several blocks.
//
// Its pieces, one in each block, have intervals of sizes b_k blended from the arcs beside them, and lengths. The
// intervals are d_k = b_k e^(c_k), where the corrections c minimise
//
//   sum over adjacent intervals (c' - c)^2 + 10 max(0, |ln d' / d| - g)^2  +  0.02 sum c^2,
//
// g the logarithm of the limit, such that the intervals of every piece sum to its length: adjacent intervals differ as
// they do on the arcs, up to a correction that changes little from interval to interval; where this exceeds the limit,
// more intervals share it. Layers, whose heights are prescribed, do not change.

#include <optional>
#include <vector>

namespace quadrille::growth {

/// The layer before or after the intervals of a piece.
struct NextLayer {
  double size = 0;        ///< b
  double correction = 0;  ///< c
};

struct LinePiece {
  double length = 0;
  std::vector<double> sizes;               ///< b_k
  std::optional<NextLayer> before, after;  ///< if it has layers at its beginning and end
};

/// The lengths of the intervals of each piece, along the line. `is_closed`: the last piece is followed by the first.
/// `limit`: greatest ratio of adjacent intervals that is aimed at, > 1.
std::vector<std::vector<double>> corrected_lengths(const std::vector<LinePiece>& pieces, bool is_closed, double limit);

}  // namespace quadrille::growth
