#include "guide/corner_override.hpp"

#include <fmt/format.h>

#include <charconv>
#include <optional>

#include "base/error.hpp"

namespace quadrille::guide {
namespace {

std::optional<int> whole_number(const std::string& text) {
  int value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  const bool is_whole = error == std::errc() && end == text.data() + text.size() && value >= 0;
  return is_whole ? std::optional<int>(value) : std::nullopt;
}

}  // namespace

CornerOverride parse_corner_override(const std::string& text) {
  const std::size_t colon = text.find(':'), equals = text.find('=');
  std::optional<int> a, b, valence;
  if (colon != std::string::npos && equals != std::string::npos && colon < equals) {
    a = whole_number(text.substr(0, colon));
    b = whole_number(text.substr(colon + 1, equals - colon - 1));
    valence = whole_number(text.substr(equals + 1));
  }
  if (!a || !b || !valence)
    throw UsageError(
        fmt::format("'{}' is not a corner valence: write CURVE_A:CURVE_B=VALENCE, for example 3:4=2", text));
  return {*a, *b, *valence};
}

}  // namespace quadrille::guide
