#pragma once
// Assigns new names to some entities of a list; no entity may get two.

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

}  // namespace quadrille
