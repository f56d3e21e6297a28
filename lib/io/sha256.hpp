#pragma once
// SHA-256 for the provenance chain.

#include <string>
#include <string_view>

namespace quadrille {

/// The digest of `bytes` in lower-case hexadecimal.
std::string sha256_hex(std::string_view bytes);

}  // namespace quadrille
