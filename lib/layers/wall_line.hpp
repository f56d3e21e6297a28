#pragma once
// A stretch of a wall, and how far points near it are from it.

#include <vector>

#include "curve/chain.hpp"

namespace quadrille::layers {

/// A point of the stretch.
struct WallFoot {
  int piece = 0;
  double t = 0;
};

class WallLine {
 public:
  WallLine() = default;
  /// Pieces follow each other. `table` must outlive the line.
  WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces);

  /// Distance from x to the stretch, its ends included, and its foot: the nearest point that is reached from `foot`
  /// without leaving the neighbourhood, or beyond a bend of the wall next to it. Meant for points that move away from
  /// the wall, with the foot of the last one.
  double distance(Vec2 x, WallFoot& foot) const;
  const std::vector<ArcPiece>& pieces() const { return pieces_; }

 private:
  /// The nearest point of the piece, from t by Newton steps; -1, +1 where it lies at the piece's start or end and
  /// beyond would be nearer.
  int settle(Vec2 x, WallFoot& foot) const;
  double distance_at(Vec2 x, const WallFoot& foot) const;
  /// Where the piece before (-1) or after (+1) the foot's own is entered.
  WallFoot entry(const WallFoot& foot, int step) const;
  bool has_piece(int piece) const { return piece >= 0 && piece < static_cast<int>(pieces_.size()); }

  const curve::CurveTable* table_ = nullptr;
  std::vector<ArcPiece> pieces_;
  std::vector<bool> bends_;  ///< by piece: the tangent jumps where it ends and the next begins
};

}  // namespace quadrille::layers
