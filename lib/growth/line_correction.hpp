#pragma once
// Corrections of the intervals of a line of nodes that crosses several blocks.
//
// Its pieces, one in each block, have intervals of sizes b_k blended from the arcs beside them, and lengths. The
// intervals are b_k e^(c_k), where the corrections c minimise
//
//   sum over adjacent intervals (c' - c)^2  +  0.02 sum c^2
//
// such that the intervals of every piece sum to its length: adjacent intervals differ as they do on the arcs, up to a
// correction that changes little from interval to interval. At layers, whose heights are prescribed, c is given.

#include <optional>
#include <vector>

namespace quadrille::growth {

struct LinePiece {
  double length = 0;
  std::vector<double> sizes;            ///< b_k
  std::optional<double> before, after;  ///< c of the last layer at its beginning and end, if it has layers there
};

/// The lengths of the intervals of each piece, along the line. `is_closed`: the last piece is followed by the first.
std::vector<std::vector<double>> corrected_lengths(const std::vector<LinePiece>& pieces, bool is_closed);

}  // namespace quadrille::growth
