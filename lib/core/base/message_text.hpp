#pragma once
// Counts, numbers and positions in messages, and text as a JSON string.

#include <charconv>
#include <concepts>
#include <optional>
#include <string>
#include <string_view>

#include "base/vec2.hpp"
#include "base/vec3.hpp"

namespace quadrille {

/// "1 block", "2 blocks".
std::string counted(std::integral auto count, const std::string& noun) {
  return std::to_string(count) + ' ' + noun + (count == 1 ? "" : "s");
}

/// The number that the whole text is; no value if it is anything else.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional<Number>(value) : std::nullopt;
}

/// "(x, y)" with six digits each. `x` must be in the coordinates of the CAD file: a position plus face.origin. If a
/// coordinate is no finite number, the text names an internal error instead: no message has "nan" for a place.
std::string position_text(Vec2 x);

/// position_text, where a coordinate that is only a rounding error relative to the other one is written as 0.
std::string rounded_position_text(Vec2 x);

/// "(x, y, z)" with six digits each; a coordinate that is only a rounding error relative to the others is written as 0.
std::string position_text(Vec3 x);

// Text as a JSON string.

/// In quotes, with escapes for quotes, backslashes and control characters. UTF-8 is copied unchanged.
std::string json_string(const std::string& text);

}  // namespace quadrille
