#pragma once
// The parts of lines that a motorcycle graph keeps, and the crossings between them.

#include <vector>

#include "quantize/motorcycle_graph.hpp"
#include "trace/merged_lines.hpp"

namespace quadrille::quantize {

struct ClippedLines {
  std::vector<graph::FinishedLine> pieces;
  std::vector<int> piece2line;             ///< the line of each piece; a line stopped from both ends has two pieces
  std::vector<graph::Crossing> crossings;  ///< Crossing::a and b number the pieces
};

/// The covered part of each line of the arrangement. A piece that was stopped ends on the line that stopped it.
ClippedLines clip_lines(const trace::LineArrangement& arrangement, const std::vector<CoveredPart>& covered);

}  // namespace quadrille::quantize
