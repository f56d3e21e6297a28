#pragma once
// Names of the entities of a list: given ones, of which no entity may get two, and for unnamed entities their kind and
// number, "curve_3".

#include <string>
#include <vector>

namespace quadrille {

struct GivenName {
  std::string name;
  std::vector<int> targets;  ///< numbers of the entities that get the name
  bool is_for_rest = false;  ///< the name is for those of the targets that no other entry names
  std::string where{};       ///< the file and the entry, for messages
};

/// Sets names[target] for all of `given`. Throws FormatError, naming both entries, if two entries name the same `kind`
/// ("curve") or if two are for the rest of it. Returns the numbers of the named entities, ascending.
std::vector<int> assign_names(std::vector<std::string>& names, const std::vector<GivenName>& given,
                              const std::string& kind);

/// Replaces empty names by "<kind>_<number>", followed by as many "_" as are necessary to differ from all given names.
/// Returns the numbers of the names that it replaced, ascending.
std::vector<int> replace_empty_names(std::vector<std::string>& names, const std::string& kind);

/// The numbers of the names that replace_empty_names may have made, ascending: for files that do not state whether a
/// name was given.
std::vector<int> presumed_numbered_names(const std::vector<std::string>& names, const std::string& kind);

}  // namespace quadrille
