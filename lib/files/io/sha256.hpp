#pragma once
// SHA-256 for the provenance chain.

#include <string>
#include <string_view>

namespace quadrille::io {

/// The digest of `bytes` in lower-case hexadecimal.
std::string sha256_hex(std::string_view bytes);
/// The same without the instructions that some processors have for it.
std::string sha256_hex_in_software(std::string_view bytes);

}  // namespace quadrille::io
