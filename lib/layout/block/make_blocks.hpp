#pragma once
// Makes a measured layout of valid blocks from a graph of separatrices.
//
// The exact map of a block folds if points of the same arc-length fraction of two long sides do not lie opposite each
// other: in strips that are thin at one end, or narrow to a neck. No other parametrization by arc length avoids this;
// a cut between points that do lie opposite each other does. A whole chord is cut lengthwise: every block of it becomes
// two, and the layout stays conforming. The cut meets arc i of the chord at the fraction f_i that minimises
//
//   sum over blocks w_ij (f_j - f_i - d_ij)^2 + w_0 sum over arcs (f_i - 1/2)^2
//
// where the points at (f_i + f_j - d_ij) / 2 and (f_i + f_j + d_ij) / 2 lie opposite each other: the segment between
// them is at right angles to the mean of the tangents. w_ij = (length / width)^2: thin blocks are weighted more. The
// answer depends neither on the chord's direction nor on where it begins, so symmetric layouts are cut symmetrically.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "block/measure_blocks.hpp"
#include "curve/chain.hpp"
#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::block {

/// A chain in a chosen direction.
struct DirectedCurve {
  const curve::Chain* chain = nullptr;
  bool backwards = false;
  curve::ChainPoint at(double f) const {
    curve::ChainPoint p = chain->at(backwards ? 1 - f : f);
    if (backwards) p.tangent = -p.tangent;
    return p;
  }
};

/// The difference d of fractions, nearest to 0, at which a(middle - d / 2) and b(middle + d / 2) lie opposite each
/// other: the segment between them is at right angles to the sum of the tangents. std::nullopt if no d
/// has both fractions in [0.05, 0.95].
std::optional<double> opposite_point_offset(const DirectedCurve& a, const DirectedCurve& b, double middle);

/// Cuts the chord of an arc; the faces of `subdivision` are blocks (block/extract_blocks.hpp), all numbers are in use.
/// `is_sound[b]`: the exact map of block b is good, and the cut may follow it; elsewhere the cut is shaped like the
/// block's two other sides. Blocks, arcs and nodes keep their numbers, new ones are numbered after them. Returns false
/// without any change if the chord crosses itself or prescribes integer lengths.
bool split_chord(graph::Subdivision& subdivision, int arc, const std::vector<bool>& is_sound);

/// subdivision_into_blocks, then split_bad_chords, then all measures, which are written to `report`.
Blocks make_blocks(const SeparatrixGraph& graph, Report& report);

/// The faces of `subdivision` are the blocks. Cuts the chords of bad blocks lengthwise through their longer sides, up
/// to four times, or until two consecutive cuts bring no improvement; if blocks remain that cannot be proved valid,
/// also through their shorter sides, from the beginning. A block is bad if its exact map cannot be proved valid
/// (BlockMeasure::divisions == 0) or has a scaled Jacobian below 0.1. Keeps the result with the fewest blocks of the
/// first kind, among these the fewest bad ones, among these the first. Layouts without bad blocks are not changed.
/// Issues a warning with the position for blocks that remain invalid.
Blocks split_bad_chords(graph::Subdivision subdivision, Report& report);

}  // namespace quadrille::block
