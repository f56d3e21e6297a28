#pragma once
// The faces of a separatrix graph as blocks.

#include "base/report.hpp"
#include "model/block_layout.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::block {

/// Each face of the graph's subdivision (graph/subdivision.hpp) must have four corners. Throws ComputeError naming and
/// locating a face that does not. Chords are filled in, measures of the blocks are not
/// (block/measure_blocks.hpp).
BlockLayout extract_blocks(const SeparatrixGraph& graph);

/// The layout of make_blocks (block/make_blocks.hpp): mended and measured.
BlockLayout extract_blocks(const SeparatrixGraph& graph, Report& report);

}  // namespace quadrille::block
