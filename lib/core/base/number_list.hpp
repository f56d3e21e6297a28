#pragma once
// Finite numbers in options, alone or in a list, "1,2.5,3".

#include <optional>
#include <string_view>
#include <vector>

namespace quadrille {

/// The number that the whole text is; no value if it is anything else.
std::optional<double> finite_number_of(std::string_view text);

/// The numbers of a list with commas; empty if something else is in it.
std::vector<double> numbers_of(std::string_view list);

}  // namespace quadrille
