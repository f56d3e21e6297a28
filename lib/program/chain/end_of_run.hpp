#pragma once
// What a run leaves: the report, the page, the line about the mesh; after a failure a picture of the last file.

#include <string>

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Writes page and report, and prints the line about the mesh. Throws OutputError, ChainFailure.
void end_run(ChainState& chain);

/// Writes the report, with what failed, and says where to look.
void end_failed_run(ChainState& chain, const ChainFailure& failure);

/// The path of a command: beside this program or, for those that are no compiled programs, in the folder `pipelines` of
/// a source tree.
std::string command_path(const std::string& name);

}  // namespace quadrille::chain
