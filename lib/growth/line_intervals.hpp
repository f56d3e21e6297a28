#pragma once
// The intervals of the lines of nodes inside blocks, from wall to wall: the arcs beside a line determine how they grow,
// and a correction along the whole line (growth/line_correction) makes them fill every block that it crosses.

#include <vector>

#include "layers/wall_layers.hpp"
#include "sizing/arc_division.hpp"

namespace quadrille::growth {

/// By block: LayeredBlock::lines.
using BlockLines = std::vector<layers::BlockLineLengths>;

/// For all lines of the nodes of elements of this order; `limit`: greatest ratio of adjacent intervals that is aimed
/// at. Cost: linear in the nodes, with some evaluations of each block's map for every line.
BlockLines line_intervals(const sizing::MeasuredLayout& measured, const layers::WallPlan& walls,
                          const sizing::ArcDivisions& divisions, double limit, int order);

}  // namespace quadrille::growth
