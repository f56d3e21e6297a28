#pragma once
// The faces of a separatrix graph as blocks, and their names: blocks of equal name are one region to a solver.

#include <vector>

#include "base/report.hpp"
#include "graph/subdivision.hpp"
#include "model/block_layout.hpp"
#include "model/name_rules.hpp"
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

/// Sets the name of every block to that of its region or, where there is one region, to the name of the face, if it has
/// one (else "block_N" is kept), then the names of `rules`. Throws FormatError, with the position of the rule, for a
/// number without block, a point in no block or on the side of one (within 1e-6 diameters), and for two rules that name
/// the same block.
void name_blocks(BlockLayout& layout, const std::vector<NameRule>& rules);

}  // namespace quadrille::block
