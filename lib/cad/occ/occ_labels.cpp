#include "occ/occ_labels.hpp"

#include <algorithm>
#include <array>

#include "base/name_text.hpp"

namespace quadrille::occ {

std::string given_name(const Handle(TCollection_HAsciiString) & text) {
  constexpr std::array automatic{"NONE", "none", "Open CASCADE * translator *", "=>[*]"};
  const std::string name = text.IsNull() ? std::string() : clean_name(text->ToCString());
  const auto fits = [&](const char* pattern) { return matches_wildcard(name, pattern); };
  return std::any_of(automatic.begin(), automatic.end(), fits) ? std::string() : name;
}

}  // namespace quadrille::occ
