#pragma once
// The nodes inside a block that has walls among its sides.
//
// Each column of nodes runs along the image of the straight line between its ends on both sides, and is cut anew: the
// layers' nodes lie at their heights above the wall; what remains is divided in the ratio of the intervals on the two
// arcs beside it, blended across the block, tilted by the one factor per interval that makes them fill the column.
// Where walls meet in a corner of the block the lines of one wall are found first, and the columns of the other run
// along them.

#include <array>
#include <vector>

#include "layers/side_table.hpp"
#include "layers/wall_line.hpp"

namespace quadrille::layers {

/// Layers along one side of a block.
struct SideLayers {
  const WallLine* wall = nullptr;  ///< nullptr: no wall
  std::vector<double> heights;     ///< of the layers' upper ends
  std::vector<WallFoot> feet;      ///< on the wall, of the side's nodes by rising s or t
};

struct LayeredBlock {
  std::array<SideTable, 4> tables;  ///< of the sides, by rising s (sides 0, 2) or t (1, 3)
  std::array<SideLayers, 4> sides;
  /// Fractions of the nodes on each side, by rising s or t, and the sides' lengths.
  std::array<std::vector<double>, 4> fractions;
  std::array<double, 4> lengths{};
};

/// Positions of all nodes, along side 0 fastest; those on the sides are not filled in. Throws ComputeError with the
/// place where a column turns back before its layers end.
/// Without a wall nodes lie where the straight lines between their ends cross in the block's (s, t). Those of
/// split_isoparametric are a blend of the ends themselves, which goes astray where the divisions of opposite sides
/// differ much.
std::vector<Vec2> layered_positions(const LayeredBlock& block, int order, Vec2 origin);

}  // namespace quadrille::layers
