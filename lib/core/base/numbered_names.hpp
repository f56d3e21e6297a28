#pragma once
// Names for unnamed entities: their kind and number, "curve_3".

#include <string>
#include <vector>

namespace quadrille {

/// Replaces empty names by "<kind>_<number>", followed by as many "_" as are necessary to differ from all given names.
/// Returns the numbers of the names that it replaced, ascending.
std::vector<int> replace_empty_names(std::vector<std::string>& names, const std::string& kind);

/// The numbers of the names that replace_empty_names may have made, ascending: for files that do not state whether a
/// name was given.
std::vector<int> presumed_numbered_names(const std::vector<std::string>& names, const std::string& kind);

}  // namespace quadrille
