#pragma once
// Reads files of new names (formats/boundary-names.md, formats/block-names.md) as rules.

#include <vector>

#include "io/whole_file.hpp"
#include "model/name_rules.hpp"

namespace quadrille::io {

/// Three forms: "name for all"; {"old name or number": "new name", "*": "name of the rest"}; or a list of {"id": N or
/// "*", "name": ...}, {"old_name": ..., "name": ...} and {"near": [x, y] or [x, y, z], "name": ...}. Throws FormatError
/// with the entry for anything else, a repeated key or an empty name.
std::vector<NameRule> read_boundary_names(const InputFile& file);

/// Rules for blocks: the same forms with the key "at" in place of "near", and without old names.
std::vector<NameRule> read_block_names(const InputFile& file);

}  // namespace quadrille::io
