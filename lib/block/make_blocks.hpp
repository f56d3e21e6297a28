#pragma once
// From a graph of separatrices to a measured layout of valid blocks.

#include "base/report.hpp"
#include "block/measure_blocks.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille {

struct Blocks {
  BlockLayout layout;  ///< with its measures
  std::vector<BlockMeasure> measures;
};

/// extract_blocks, then mend_blocks, then all measures, which are told to `report`.
Blocks make_blocks(const SeparatrixGraph& graph, Report& report);

/// Cuts the chords of blocks whose exact map cannot be proved valid (BlockMeasure::divisions == 0) lengthwise through
/// their long sides, up to four times; keeps the result only if fewer such blocks are left. Layouts without such blocks
/// are not touched. Warns of what stays invalid, with the place.
Blocks mend_blocks(BlockLayout layout, Report& report);

}  // namespace quadrille
