#pragma once
// Text as a JSON string.

#include <string>

namespace quadrille {

/// In quotes, with escapes for quotes, backslashes and control characters. UTF-8 is copied unchanged.
std::string json_string(const std::string& text);

}  // namespace quadrille
