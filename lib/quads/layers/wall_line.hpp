#pragma once
// The boundary along a wall as one line of curve pieces, and distances of nearby points from it.

#include <array>
#include <vector>

#include "curve/chain.hpp"

namespace quadrille::layers {

/// A point of a wall line.
struct WallPoint {
  int piece = 0;
  double t = 0;  ///< parameter on the piece's curve
};

/// The direction of a piece at its beginning or its end, of length 1.
Vec2 direction(const curve::CurveTable& table, const ArcPiece& piece, bool at_end);

class WallLine {
 public:
  WallLine() = default;
  /// Pieces are consecutive. `table` must outlive the line.
  WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces);

  /// Continues the line straight beyond its beginning (-1) or its end (+1).
  void extend(int step) { is_extended_[step < 0 ? 0 : 1] = true; }

  /// Distance from x to the line, its ends included. On entry `foot` is a start, on return the nearest point that is
  /// reached from it continuously, or the nearest one beyond a bend next to it. Intended for points that move away from
  /// the wall, each with the foot of the last one. Newton's method, to round-off.
  double distance(Vec2 x, WallPoint& foot) const;
  const std::vector<ArcPiece>& pieces() const { return pieces_; }

 private:
  /// Moves the foot to the nearest point of its piece, by Newton steps. Returns -1 or +1 where this is the piece's
  /// start or end and points beyond it would be nearer, else 0.
  int move_foot(Vec2 x, WallPoint& foot) const;
  double distance_at(Vec2 x, const WallPoint& foot) const;
  /// From the straight continuation beyond the line's beginning (-1) or end (+1).
  double distance_beyond(Vec2 x, int step) const;
  /// The point where the piece before (-1) or after (+1) the foot's own begins, seen from there.
  WallPoint entry(const WallPoint& foot, int step) const;
  /// Follows the line from piece to piece while the distance decreases; returns the distance.
  double follow_pieces(Vec2 x, WallPoint& foot) const;
  bool has_piece(int piece) const { return piece >= 0 && piece < static_cast<int>(pieces_.size()); }

  const curve::CurveTable* table_ = nullptr;
  std::vector<ArcPiece> pieces_;
  std::array<bool, 2> is_extended_{};
  std::vector<bool> bends_;  ///< by piece: the tangent jumps where it ends and the next begins
};

}  // namespace quadrille::layers
