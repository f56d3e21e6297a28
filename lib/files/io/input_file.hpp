#pragma once
// An input file, read whole into memory, with its digest.

#include <string>
#include <vector>

#include "model/provenance.hpp"

namespace quadrille::io {

struct InputFile : FileIdentity {
  std::string bytes;
};

/// Reads `path` ("-": standard input). Throws FormatError when it cannot be read, is a directory or a terminal.
InputFile read_input(const std::string& path);

}  // namespace quadrille::io
