#pragma once
// An input file, read whole into memory, with its digest.

#include <string>
#include <vector>

#include "model/provenance.hpp"

namespace quadrille::io {

struct InputFile {
  std::string name;  ///< for messages; "standard input" for "-"
  std::string bytes;
  std::string sha256;

  InputDigest digest(const std::string& format) const { return {format, sha256}; }
};

/// Reads `path` ("-": standard input). Throws FormatError when it cannot be read, is a directory or a terminal.
InputFile read_input(const std::string& path);

/// Whether one of the files was made from the other: the provenance chain of one contains the digest of the other.
bool have_same_origin(const InputFile& first, const Provenance& first_chain, const InputFile& second,
                      const Provenance& second_chain);

/// Throws FormatError unless one of the files was made from the other.
void require_same_origin(const InputFile& first, const Provenance& first_chain, const InputFile& second,
                         const Provenance& second_chain);

}  // namespace quadrille::io
