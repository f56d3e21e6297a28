#pragma once
// Digests: SHA-256 for the provenance chain, and a checksum for damage, sixteen bytes behind an HDF5 image. libhdf5
// ignores what follows its end of file, and cuts it off when another program edits the file: so a wrong checksum means
// damage, a missing one a foreign writer. Private to io.

#include <cstddef>
#include <string>
#include <string_view>

namespace quadrille::io {

constexpr std::size_t checksum_size = 16;

enum class Checksum { missing, right, wrong };

void append_checksum(std::string& image);
/// Also returns the image without the checksum.
Checksum verify_checksum(const std::string& bytes, std::string_view& image);

/// The digest of `bytes` in lower-case hexadecimal.
std::string sha256_hex(std::string_view bytes);
/// The same without the instructions that some processors have for it.
std::string sha256_hex_in_software(std::string_view bytes);

}  // namespace quadrille::io
