#pragma once
// The header of every stage file: format, version [major, minor], producer, provenance. Private to io.

#include <string>

#include "io/archive.hpp"
#include "io/renamed_keys.hpp"
#include "model/provenance.hpp"

namespace quadrille::io {

struct FormatVersion {
  const char* format;                        ///< "tri-mesh"
  int major, minor;                          ///< version written; any minor of this major and of the one before is read
  std::span<const RenamedKey> renamed = {};  ///< members that had another name in the previous major version
};

/// The last step of the provenance chain, "cad2tri 0.1.0".
std::string producer_of(const Provenance& provenance);

/// Throws FormatError unless the file is of this format and of the present or the previous major version; the messages
/// for older and for newer versions differ.
void require_version(const std::string& file_name, const FormatVersion& expected, const std::string& format,
                     const std::vector<int>& version);

/// Runs `describe` on a file whose `version` require_version accepts; members of a file of the previous major version
/// are read by their former names.
void describe_version(Archive& archive, const FormatVersion& present, const std::vector<int>& version,
                      const std::function<void(Archive&)>& describe);

void describe_provenance(Archive& archive, Provenance& provenance);

/// The provenance chain as one line of JSON, and its inverse.
std::string provenance_text(Provenance provenance);
Provenance parse_provenance(const std::string& text, const std::string& file_name);

}  // namespace quadrille::io
