#pragma once
// The boundary along a wall as one line of curve pieces, and distances of nearby points from it.

#include <vector>

#include "curve/chain.hpp"

namespace quadrille::layers {

/// A point of a wall line.
struct WallPoint {
  int piece = 0;
  double t = 0;  ///< parameter on the piece's curve
};

class WallLine {
 public:
  WallLine() = default;
  /// Pieces are consecutive. `table` must outlive the line.
  WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces);

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
  /// The point where the piece before (-1) or after (+1) the foot's own begins, seen from there.
  WallPoint entry(const WallPoint& foot, int step) const;
  /// Follows the line from piece to piece while the distance decreases; returns the distance.
  double follow_pieces(Vec2 x, WallPoint& foot) const;
  bool has_piece(int piece) const { return piece >= 0 && piece < static_cast<int>(pieces_.size()); }

  const curve::CurveTable* table_ = nullptr;
  std::vector<ArcPiece> pieces_;
  std::vector<bool> bends_;  ///< by piece: the tangent jumps where it ends and the next begins
};

}  // namespace quadrille::layers
