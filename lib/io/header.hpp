#pragma once
// What every stage file begins with: format, version [major, minor], producer, provenance. Private to io.

#include <string>

#include "io/archive.hpp"
#include "io/renamed_keys.hpp"
#include "model/provenance.hpp"

namespace quadrille::io {

struct FormatVersion {
  const char* format;                        ///< "tri-mesh"
  int major, minor;                          ///< what is written; any minor of this major and of the one before is read
  std::span<const RenamedKey> renamed = {};  ///< what was called otherwise in the major version before
};

/// "cad2tri 0.1.0": the last step of the chain.
std::string producer_of(const Provenance& provenance);

/// Throws FormatError unless it is this format, of the present major version or the one before (one sentence for older,
/// one for newer ones).
void require_version(const std::string& file_name, const FormatVersion& expected, const std::string& format,
                     const std::vector<int>& version);

/// Runs `describe` on a file of `version`, which require_version accepts: by former names where it is of the major
/// version before.
void describe_version(Archive& archive, const FormatVersion& present, const std::vector<int>& version,
                      const std::function<void(Archive&)>& describe);

void describe_provenance(Archive& archive, Provenance& provenance);

/// The chain as one line of JSON, and back.
std::string provenance_text(Provenance provenance);
Provenance parse_provenance(const std::string& text, const std::string& file_name);

}  // namespace quadrille::io
