#pragma once
// New names for some of many things, each of which may get one only once.

#include <string>
#include <vector>

namespace quadrille {

struct GivenName {
  std::string name;
  std::vector<int> targets;  ///< who gets it
  bool is_for_rest = false;  ///< all that nobody else names get it
  std::string where{};       ///< the file and the entry, for messages
};

/// Sets names[target] for all of `given`. Throws FormatError, naming both entries, where two name the same `kind`
/// ("curve") or the rest of them. Returns who got a name, ascending.
std::vector<int> assign_names(std::vector<std::string>& names, const std::vector<GivenName>& given,
                              const std::string& kind);

}  // namespace quadrille
