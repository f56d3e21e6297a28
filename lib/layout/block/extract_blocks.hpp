#pragma once
// The faces of a separatrix graph as blocks.

#include "base/report.hpp"
#include "graph/subdivision.hpp"
#include "model/block_layout.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::block {

/// The graph's subdivision, whose faces are the blocks. Throws ComputeError naming and locating a face that does not
/// have four corners.
graph::Subdivision subdivision_into_blocks(const SeparatrixGraph& graph);

/// The faces of a subdivision as blocks with the faces' numbers. Chords are filled in, measures of the blocks are not
/// (block/measure_blocks.hpp).
BlockLayout blocks_of(const graph::Subdivision& subdivision);

/// The layout of both: blocks as they are in the graph.
BlockLayout extract_blocks(const SeparatrixGraph& graph);

/// The layout of make_blocks (block/make_blocks.hpp): mended and measured.
BlockLayout extract_blocks(const SeparatrixGraph& graph, Report& report);

}  // namespace quadrille::block
