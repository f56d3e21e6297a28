#pragma once
// The stage blocksplit: the blocks of a separatrix graph.

#include <optional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/run.hpp"
#include "model/block_layout.hpp"
#include "model/name_rules.hpp"
#include "model/separatrix_graph.hpp"
#include "stage/stage_input.hpp"

namespace quadrille::stage {

struct BlocksplitOptions {
  std::string names_file;  ///< path of a file of block names, which the caller reads
};
void declare(Options& options, BlocksplitOptions& blocksplit);

/// Blocks with the names of their regions or of the face, then those of `names` (block/extract_blocks.hpp). Throws
/// FormatError if the graph breaks a rule or a name has no block, ComputeError if a face of the graph has not four
/// sides.
BlockLayout blocksplit(const Input<SeparatrixGraph>& graph, const std::optional<Input<std::vector<NameRule>>>& names,
                       const BlocksplitOptions& options, Run& run);

}  // namespace quadrille::stage
