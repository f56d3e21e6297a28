#pragma once
// The sides of blocks on walls, their layers, and the arcs that start there (rules 1 to 6 of layer_rules).

#include <array>
#include <vector>

#include "curve/chain.hpp"
#include "layers/wall_line.hpp"
#include "layers/wall_spec.hpp"
#include "model/block_layout.hpp"

namespace quadrille::layers {

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

struct WallSides {
  std::vector<WallSide> sides;
  std::vector<std::array<int, 4>> of_block;  ///< by block and side: number in `sides` or -1
  std::vector<std::array<int, 2>>
      at_arc_end;  ///< by arc and end (0: from, 1: to): the wall side at which it starts or -1
  std::vector<std::array<int, 2>> overruled;  ///< ascending pairs {spec, the finer one that replaces it}
};

/// `curve_spec` as from curve_walls.
WallSides find_wall_sides(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
                          const std::vector<WallSpec>& specs);

/// The greatest curvature (1 / length) with which the side bends towards its block; 0: it bends nowhere towards it.
double greatest_bend(const curve::CurveTable& table, const WallSide& wall);

/// The point of the wall line at a point of the side's arc; `backwards`: the side is directed against its arc.
WallPoint wall_point(const WallSide& wall, const curve::ChainPoint& on_arc, bool backwards);

}  // namespace quadrille::layers
