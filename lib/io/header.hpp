#pragma once
// What every stage file begins with: format, version [major, minor], producer, provenance. Private to io.

#include <string>

#include "io/archive.hpp"
#include "model/provenance.hpp"

namespace quadrille::io {

struct FormatVersion {
  const char* format;  ///< "tri-mesh"
  int major, minor;    ///< what is written; any minor of the same major is read
};

/// "cad2tri 0.1.0": the last step of the chain.
std::string producer_of(const Provenance& provenance);

/// Throws FormatError: not this format, or another major version (one sentence for older, one for newer).
void require_version(const std::string& file_name, const FormatVersion& wanted, const std::string& format,
                     const std::vector<int>& version);

void describe_provenance(Archive& archive, Provenance& provenance);

/// The chain as one line of JSON, and back.
std::string provenance_text(Provenance provenance);
Provenance parse_provenance(const std::string& text, const std::string& file_name);

}  // namespace quadrille::io
