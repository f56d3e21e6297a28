#pragma once
// Blocks as a STEP model: topologically connected planar faces that other programs open. No kernel names here.

#include <string>

#include "model/block_layout.hpp"

namespace quadrille::cad {

/// One shell with one face for each block, named as the block, in the face's plane in space and in the unit of the
/// CAD file (millimetre where that is unknown). Every piece of an arc is one edge, shared by the faces on both sides;
/// vertices are shared likewise; edges on the boundary carry the name of their CAD curve. Straight pieces are lines,
/// the others rational B-splines, exactly. The same layout gives the same bytes. Throws ComputeError for a layout
/// whose arcs do not meet.
std::string step_of_blocks(const BlockLayout& layout);

}  // namespace quadrille::cad
