#pragma once
// The sides of blocks on walls, their layers, and the arcs that start there (rules 1 to 6 of layer_rules).

#include <array>
#include <memory>
#include <vector>

#include "curve/chain.hpp"
#include "layers/wall_spec.hpp"
#include "model/block_layout.hpp"
#include "sizing/chart_scale.hpp"

namespace quadrille::layers {

/// A point of a wall line.
struct WallPoint {
  int piece = 0;
  double t = 0;  ///< parameter on the piece's curve
};

/// The direction of a piece at its beginning or its end, of length 1.
Vec2 direction(const curve::CurveTable& table, const ArcPiece& piece, bool at_end);

/// The boundary along a wall as one line of curve pieces, and distances of nearby points from it.
class WallLine {
 public:
  WallLine() = default;
  /// Pieces are consecutive. `table` must outlive the line.
  WallLine(const curve::CurveTable& table, std::vector<ArcPiece> pieces,
           std::shared_ptr<const sizing::ChartScale> scale = {});

  /// Continues the line straight beyond its beginning (-1) or its end (+1).
  void extend(int step) { is_extended_[step < 0 ? 0 : 1] = true; }

  /// Distance from x to the line, its ends included. On entry `foot` is a start, on return the nearest point that is
  /// reached from it continuously, or the nearest one beyond a bend next to it. Intended for points that move away from
  /// the wall, each with the foot of the last one. Newton's method, to round-off. On a curved face the length in space
  /// of the straight line of the chart from the foot to x.
  double distance(Vec2 x, WallPoint& foot) const;
  /// Lengths in space over those in the chart of a curved face; 1 in the plane.
  double scale_at(Vec2 x) const { return scale_ ? scale_->at(x).scale : 1; }
  const std::vector<ArcPiece>& pieces() const { return pieces_; }

 private:
  /// Moves the foot to the nearest point of its piece, by Newton steps. Returns -1 or +1 where this is the piece's
  /// start or end and points beyond it would be nearer, else 0.
  int move_foot(Vec2 x, WallPoint& foot) const;
  double distance_at(Vec2 x, const WallPoint& foot) const;
  double distance_in_plane(Vec2 x, WallPoint& foot) const;
  /// From the straight continuation beyond the line's beginning (-1) or end (+1).
  double distance_beyond(Vec2 x, int step) const;
  /// The point where the piece before (-1) or after (+1) the foot's own begins, seen from there.
  WallPoint entry(const WallPoint& foot, int step) const;
  /// Follows the line from piece to piece while the distance decreases; returns the distance.
  double follow_pieces(Vec2 x, WallPoint& foot) const;
  bool has_piece(int piece) const { return piece >= 0 && piece < static_cast<int>(pieces_.size()); }

  const curve::CurveTable* table_ = nullptr;
  std::shared_ptr<const sizing::ChartScale> scale_;
  std::vector<ArcPiece> pieces_;
  std::array<bool, 2> is_extended_{};
  std::vector<bool> bends_;  ///< by piece: the tangent jumps where it ends and the next begins
};

struct WallSide {
  int block = 0, side = 0;
  int spec = 0;
  WallLine line;    ///< the side between those that continue it along the boundary, in the direction of the side
  WallPoint begin;  ///< the side's first point on that line
  WallPoint end;    ///< its last
  /// The number of intervals above the layers in blocks of their own, where layers are compressed if the block is lower
  /// than they are (compressed_heights); 0: the blocks are not.
  int own_intervals = 0;
};

/// An end of an arc at which layers start.
struct LayeredEnd {
  int arc = 0, end = 0;
  int side = 0;  ///< of the wall, in WallSides::sides
};

struct WallSides {
  std::vector<WallSide> sides;
  std::vector<std::array<int, 4>> of_block;  ///< by block and side: number in `sides` or -1
  std::vector<std::array<int, 2>>
      at_arc_end;  ///< by arc and end (0: from, 1: to): the wall side at which it starts or -1
  std::vector<LayeredEnd> layered_ends() const;  ///< ascending
  std::vector<std::array<int, 2>> overruled;     ///< ascending pairs {spec, the finer one that replaces it}
};

/// `curve_spec` as from curve_walls. `scale`: of a curved face.
WallSides find_wall_sides(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
                          const std::vector<WallSpec>& specs,
                          const std::shared_ptr<const sizing::ChartScale>& scale = {});

/// The greatest curvature (1 / length, of a curved face in space) with which the side bends towards its block; 0: it
/// bends nowhere towards it.
double greatest_bend(const curve::CurveTable& table, const WallSide& wall);

/// The point of the wall line at a point of the side's arc; `backwards`: the side is directed against its arc.
WallPoint wall_point(const WallSide& wall, const curve::ChainPoint& on_arc, bool backwards);

}  // namespace quadrille::layers
