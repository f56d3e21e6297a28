#pragma once
// Enums whose values have names in files, options, reports and messages. Such an enum, whose values are 0, 1, 2, ...,
// declares their names once, in their order, beside itself and in its own namespace, where argument-dependent lookup
// finds them:
//
//   enum class SizeRule { nearest, at_most };
//   constexpr auto enum_names(SizeRule) { return std::to_array({"nearest", "at-most"}); }
//
// io reads and writes it as text (io/archive.hpp), cli makes it an option (base/options.hpp).

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace quadrille {

template <typename Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires(Enum value) {
  enum_names(value);
};

/// The name of `value`. Throws Defect if the list lacks it.
template <NamedEnum Enum>
std::string enum_name(Enum value) {
  const auto names = enum_names(value);
  const auto number = static_cast<std::size_t>(value);
  if (number >= names.size()) throw Defect("an enum value has no name");
  return names[number];
}

/// The value whose name is `name`; std::nullopt if no value has that name.
template <NamedEnum Enum>
std::optional<Enum> enum_value(std::string_view name) {
  const auto names = enum_names(Enum{});
  const auto found = std::find(names.begin(), names.end(), name);
  return found == names.end() ? std::nullopt : std::optional(static_cast<Enum>(found - names.begin()));
}

/// All names, in the order of the values.
template <NamedEnum Enum>
std::vector<std::string> all_enum_names() {
  const auto names = enum_names(Enum{});
  return {names.begin(), names.end()};
}

/// "a", "a or b", "a, b or c": for messages.
inline std::string alternatives(const std::vector<std::string>& names) {
  std::string list;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (i > 0) list += i + 1 < names.size() ? ", " : " or ";
    list += names[i];
  }
  return list;
}

}  // namespace quadrille
