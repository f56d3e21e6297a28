#pragma once
// The critical points of a run: from critpoints, from the user, or as a user edited them in the work folder.

#include "chain/chain_state.hpp"

namespace quadrille::chain {

/// Makes `files.nodes`, with these words for critpoints beside the chosen ones. Returns false as run_stage does.
bool make_nodes(ChainState& chain, NodeFiles& files, const std::vector<std::string>& words);

/// Whether the nodes need a field of the phase form, as their file states.
bool have_phase_form(ChainState& chain, NodeFiles& files);

/// Whether the nodes are not those of the harmonic field: by their form, or because somebody has edited them and left
/// the form as it was. Those of another face are refused when their field is solved.
bool needs_own_field(ChainState& chain, NodeFiles& files);

/// Throws FormatError unless the file holds critical points that keep their rules. CRT-R07 and CRT-R16 are about the
/// record of the search, which an editor may leave as it was.
void require_nodes(const io::InputFile& file);

}  // namespace quadrille::chain
