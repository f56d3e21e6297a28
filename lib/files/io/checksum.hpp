#pragma once
// Sixteen bytes behind an HDF5 image that reveal damage. libhdf5 ignores what follows its end of file, and
// cuts it off when another program edits the file: so a wrong checksum means damage, a missing one a foreign writer.
// Private to io.

#include <cstddef>
#include <string>
#include <string_view>

namespace quadrille::io {

constexpr std::size_t checksum_size = 16;

enum class Checksum { missing, right, wrong };

void append_checksum(std::string& image);
/// Also returns the image without the checksum.
Checksum verify_checksum(const std::string& bytes, std::string_view& image);

}  // namespace quadrille::io
