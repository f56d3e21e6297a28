#pragma once
// The nodes inside a block that has walls among its sides, or whose chords continue layers.
//
// Each line of nodes runs along the image of the straight line between its ends on both sides of the block and is
// divided again (divide_normal_line). Where walls meet in a corner of the block, the lines along one wall's normals are
// placed first, and the lines along the other's run along them (rule 8 of layer_rules). Where lines in both directions
// are given, those along a wall's normals come last: they have exactly the heights of its layers. Without walls those
// with the shortest interval do, and where no interval is shorter, nodes lie at the mean of both. Where shifts along
// the layers are given, these lines run through the shifted places of their nodes, and are divided once more.

#include <array>
#include <optional>
#include <vector>

#include "layers/normal_line.hpp"
#include "layers/shift_along_rows.hpp"
#include "layers/side_table.hpp"

namespace quadrille::layers {

using BlockLineLengths = std::array<std::vector<std::vector<double>>, 2>;

struct LayeredBlock {
  std::array<SideTable, 4> tables;  ///< of the sides, by rising s (sides 0, 2) or t (1, 3)
  std::array<SideLayers, 4> sides;
  /// Fractions of the nodes on each side, by rising s or t, and the sides' lengths.
  std::array<std::vector<double>, 4> fractions;
  std::array<double, 4> lengths{};
  /// If given, the lengths of the intervals above the layers of every line of nodes: columns (0) by their number along
  /// side 0, rows (1) by their number along side 1. An empty direction follows from the sides (measured_line).
  BlockLineLengths lines = {};
  /// If given for a direction that has lines, factors of these intervals once adjacent lines are tied to each other.
  BlockLineLengths factors = {};
  /// If given, how far the vertices of lines along a wall's normals move along the layers: rows are those of the
  /// block with these lines as columns.
  RowShifts shifts = {};
  /// If given, the block has the map of the whole block that it is one half of.
  std::optional<sizing::HalvedSide> halved = {};
};

/// The inner columns (0) or rows (1), by their number along the side; the first and the last one are empty.
std::vector<BlockLine> block_lines(const LayeredBlock& block, int direction, int order, const CadFace& face);

/// Positions of all nodes, along side 0 fastest; those on the sides are not filled in. Without a wall nodes lie where
/// the straight lines between their ends cross in the block's (s, t): the blend of the ends themselves, which
/// refine/split_isoparametric uses, may lie outside the block if the divisions of opposite sides differ much. Throws
/// ComputeError, with the position, if a line turns back before its layers end.
std::vector<Vec2> layered_positions(const LayeredBlock& block, int order, const CadFace& face);

}  // namespace quadrille::layers
