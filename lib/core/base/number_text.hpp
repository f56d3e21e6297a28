#pragma once
// Numbers in texts.

#include <charconv>
#include <optional>
#include <string_view>

namespace quadrille {

/// The number that the whole text is; no value if it is anything else.
template <class Number>
std::optional<Number> number_of(std::string_view text) {
  Number value{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc() && end == text.data() + text.size() ? std::optional<Number>(value) : std::nullopt;
}

}  // namespace quadrille
