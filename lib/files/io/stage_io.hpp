#pragma once
// Writes and reads a stage file, header included, from the description of its members. Private to io.

#include <functional>
#include <string>

#include "io/archive.hpp"
#include "io/header.hpp"
#include "io/input_file.hpp"

namespace quadrille::io {

using Describe = std::function<void(Archive&)>;

std::string hdf5_stage_bytes(const FormatVersion& version, const Provenance& provenance, const Describe& describe);
Provenance read_hdf5_stage(const InputFile& file, const FormatVersion& version, const Describe& describe);

std::string json_stage_bytes(const FormatVersion& version, const Provenance& provenance, const Describe& describe);
Provenance read_json_stage(const InputFile& file, const FormatVersion& version, const Describe& describe);

}  // namespace quadrille::io
