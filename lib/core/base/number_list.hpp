#pragma once
// Lists of numbers in options, "1,2.5,3".

#include <string_view>
#include <vector>

namespace quadrille {

/// The finite numbers of a list with commas; empty if something else is in it.
std::vector<double> numbers_of(std::string_view list);

}  // namespace quadrille
