#pragma once
// Which sides of blocks lie on walls, and which ends of arcs leave them.
//
// Wall sides that share the arc between them (on straight boundary, V = 2) make a run: one wall as far as its layers
// are concerned. Where the parts of a run are asked for different layers, the finest ones win.

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
  WallLine line;   ///< the side with the boundary that runs straight on from it, walked as the side is
  WallFoot begin;  ///< the side's first point on that line
  WallFoot end;    ///< its last
};

struct WallSides {
  std::vector<WallSide> sides;
  std::vector<std::array<int, 4>> of_block;    ///< by block and side: index into sides or -1
  std::vector<std::array<int, 2>> at_arc_end;  ///< by arc and end (0: from, 1: to): a wall that it leaves there or -1
  std::vector<std::array<int, 2>> overruled;   ///< {spec that lost, spec that won} in a run
};

/// `curve_spec` as from curve_walls. A side that only partly lies on a wall counts as a whole.
WallSides find_wall_sides(const BlockLayout& layout, const curve::CurveTable& table, const std::vector<int>& curve_spec,
                          const std::vector<WallSpec>& specs);

/// The end (0: from, 1: to) of the arc of a half-edge at which it begins.
int beginning_of(HalfEdge directed);

}  // namespace quadrille::layers
