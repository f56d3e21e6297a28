#pragma once
// Bytes as text (RFC 4648, with padding).

#include <optional>
#include <string>
#include <string_view>

namespace quadrille {

std::string base64(std::string_view bytes);

/// The bytes of a text that base64() could have written; std::nullopt for any other text.
std::optional<std::string> bytes_of_base64(std::string_view text);

}  // namespace quadrille
