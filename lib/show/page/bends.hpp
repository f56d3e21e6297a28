#pragma once
// Curves as cubic Bezier pieces: sides of elements relative to their chords, in 16 bits; chains of curves in the frame.

#include <array>
#include <cstdint>
#include <vector>

#include "draw/pixel_curve.hpp"
#include "model/arc_graph.hpp"
#include "page/page_frame.hpp"

namespace quadrille::page {

/// Positions and derivatives of a side at s = k / 8, s in [0, 1].
using SideSamples = std::array<draw::CurvePoint, 9>;

/// Sides of elements as cubic pieces. A side from a to b has 0 (straight), 1, 2 or 4 pieces of equal parameter length;
/// a point p of it is stored as the complex number (p - a) / (b - a) in units of 1 / 8192: both inner control points
/// of each piece, and the end of each piece but the last.
struct Bends {
  std::vector<std::uint8_t> pieces;  ///< one per side
  std::vector<std::int16_t> points;  ///< two per control point

  /// Appends a side. The pieces are exact to 3e-4 of the side's chord, or are four.
  void append(const SideSamples& side);
};

/// Chains of cubic pieces: chain k has the points [offsets[k], offsets[k+1]), three for each piece after the first.
struct Chains {
  std::vector<std::int32_t> offsets{0};
  std::vector<std::int32_t> points;  ///< two per point, in the frame's units

  /// Appends a chain of pieces of curves, exact to 1e-6 of the frame's extent. `curve_of` returns the curve of a piece.
  template <typename CurveOf>
  void append(const PageFrame& frame, const std::vector<ArcPiece>& pieces, const CurveOf& curve_of) {
    for (const ArcPiece& piece : pieces) append_piece(frame, curve_of(piece.curve), piece.t0, piece.t1);
    close_chain();
  }
  void append_piece(const PageFrame& frame, const Nurbs& curve, double t0, double t1);
  void close_chain() { offsets.push_back(static_cast<std::int32_t>(points.size() / 2)); }
};

}  // namespace quadrille::page
