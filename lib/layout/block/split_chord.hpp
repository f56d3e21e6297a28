#pragma once
// Cuts a whole chord of a layout lengthwise: every block of it becomes two, and the layout stays conforming.
//
// For blocks whose exact map folds because points of the same arc-length fraction of two long sides do not lie opposite
// each other: strips that are thin at one end, or narrow to a neck. No other parametrization by arc length avoids this;
// a cut between points that do lie opposite each other does.
//
// The cut meets arc i of the chord at the fraction f_i that minimises
//
//   sum over blocks w_ij (f_j - f_i - d_ij)^2 + w_0 sum over arcs (f_i - 1/2)^2
//
// where the points at (f_i + f_j - d_ij) / 2 and (f_i + f_j + d_ij) / 2 lie opposite each other: the segment between
// them is at right angles to the mean of the tangents. w_ij = (length / width)^2: thin blocks are weighted more. The
// answer depends neither on the chord's direction nor on where it begins, so symmetric layouts are cut symmetrically.

#include <vector>

#include "graph/subdivision.hpp"

namespace quadrille::block {

/// Cuts the chord of an arc; the faces of `subdivision` are blocks (block/extract_blocks.hpp), all numbers are in use.
/// `is_sound[b]`: the exact map of block b is good, and the cut may follow it; elsewhere the cut is shaped like the
/// block's two other sides. Blocks, arcs and nodes keep their numbers, new ones are numbered after them. Returns false
/// without any change if the chord crosses itself or prescribes integer lengths.
bool split_chord(graph::Subdivision& subdivision, int arc, const std::vector<bool>& is_sound);

}  // namespace quadrille::block
