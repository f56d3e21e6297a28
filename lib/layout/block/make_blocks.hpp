#pragma once
// Makes a measured layout of valid blocks from a graph of separatrices.

#include "base/report.hpp"
#include "block/measure_blocks.hpp"
#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::block {

struct Blocks {
  BlockLayout layout;  ///< with its measures
  std::vector<BlockMeasure> measures;
};

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
