#pragma once
// The header of every stage file: format, version [major, minor], producer, provenance. Private to io.

#include <string>

#include "io/archive.hpp"
#include "model/provenance.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::io {

/// The last step of the provenance chain, "cad2tri 0.1.0".
std::string producer_of(const Provenance& provenance);

/// Throws FormatError unless the file is of this format and of its major version; the messages for older and for newer
/// versions differ.
void require_version(const std::string& file_name, const StageFormat& expected, const std::string& format,
                     const std::vector<int>& version);

void describe_provenance(Archive& archive, Provenance& provenance);

/// The provenance chain as one line of JSON, and its inverse.
std::string provenance_text(Provenance provenance);
Provenance parse_provenance(const std::string& text, const std::string& file_name);

}  // namespace quadrille::io
