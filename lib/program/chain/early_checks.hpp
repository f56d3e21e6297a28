#pragma once
// What the command line and the headers of files tell before any work: options of all stages, inputs that are missing,
// outputs that cannot be written or would replace an input.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// What needs no files. Throws UsageError.
void check_command_line(const ChainOptions& options, const StageOptions& values);

/// The shape; without one on the command line, that of the only files with the needed ending in the work folder. Throws
/// UsageError.
std::string shape_of(const ChainOptions& options, const StageOptions& values);

/// The name of the stage files: that of the shape without folders and ending.
std::string stem_of(const std::string& shape);

/// The ending of the file that quadexport reads: of a mesh, or of blocks for STEP.
std::string exported_ending(const ChainOptions& options, const StageOptions& values);

/// Inputs and outputs. Throws UsageError, FormatError for an input and OutputError for an output.
void check_files(const ChainState& chain);

/// What the options ask of the shape, such as names of boundaries. Throws ChainFailure.
void check_face(ChainState& chain);

}  // namespace quadrille::chain
