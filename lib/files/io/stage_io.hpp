#pragma once
// Writes and reads a stage file, header included, from the description of its members. Private to io.

#include <functional>
#include <string>

#include "io/archive.hpp"
#include "io/header.hpp"
#include "io/input_file.hpp"

namespace quadrille::io {

using Describe = std::function<void(Archive&)>;

std::string described_bytes(const StageFormat& format, const Provenance& provenance, const Describe& describe);
/// `provenance` is read before `describe` runs.
void read_described(const InputFile& file, const StageFormat& format, Provenance& provenance, const Describe& describe);

}  // namespace quadrille::io
