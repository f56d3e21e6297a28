#pragma once
// Enums whose values have names in files, options, reports and messages. Such an enum declares its names once, beside
// itself and in its own namespace, where argument-dependent lookup finds them:
//
//   enum class SizeRule { nearest, at_most };
//   constexpr auto enum_names(SizeRule) {
//     return std::to_array<EnumName<SizeRule>>({{SizeRule::nearest, "nearest"}, {SizeRule::at_most, "at-most"}});
//   }
//
// io reads and writes it as text (io/archive.hpp), cli makes it an option (base/options.hpp).

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "base/error.hpp"

namespace quadrille {

template <typename Enum>
struct EnumName {
  Enum value;
  const char* name;
};

template <typename Enum>
concept NamedEnum = std::is_enum_v<Enum> && requires(Enum value) {
  enum_names(value);
};

/// The name of `value`. Throws Defect if the table lacks the value.
template <NamedEnum Enum>
std::string enum_name(Enum value) {
  for (const auto& entry : enum_names(value))
    if (entry.value == value) return entry.name;
  throw Defect("an enum value has no name");
}

/// The value whose name is `name`; std::nullopt if no value has that name.
template <NamedEnum Enum>
std::optional<Enum> enum_value(std::string_view name) {
  for (const auto& entry : enum_names(Enum{}))
    if (entry.name == name) return entry.value;
  return std::nullopt;
}

/// All names, in the order of the table.
template <NamedEnum Enum>
std::vector<std::string> all_enum_names() {
  std::vector<std::string> names;
  for (const auto& entry : enum_names(Enum{})) names.emplace_back(entry.name);
  return names;
}

/// "a", "a or b", "a, b or c": for messages.
std::string alternatives(const std::vector<std::string>& names);

}  // namespace quadrille
