#include "base/assign_names.hpp"

#include <fmt/format.h>

#include "base/error.hpp"

namespace quadrille {

std::vector<int> assign_names(std::vector<std::string>& names, const std::vector<GivenName>& given,
                              const std::string& kind) {
  std::vector<const GivenName*> by_target(names.size(), nullptr);
  std::vector<const GivenName*> rest(names.size(), nullptr);
  const auto claim = [](const GivenName*& owner, const GivenName& claimant, const std::string& what) {
    if (owner != nullptr)
      throw FormatError(fmt::format("{} names {}, as {} does: \"{}\" or \"{}\"?", claimant.where, what, owner->where,
                                    claimant.name, owner->name));
    owner = &claimant;
  };
  for (const GivenName& g : given) {
    for (const int target : g.targets)
      if (g.is_for_rest)
        claim(rest[target], g, fmt::format("every other {}", kind));
      else
        claim(by_target[target], g, fmt::format("{} {}", kind, target));
  }
  std::vector<int> named;
  for (std::size_t i = 0; i < names.size(); ++i)
    if (const GivenName* owner = by_target[i] != nullptr ? by_target[i] : rest[i]) {
      names[i] = owner->name;
      named.push_back(static_cast<int>(i));
    }
  return named;
}

}  // namespace quadrille
