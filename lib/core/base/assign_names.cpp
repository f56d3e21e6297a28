#include "base/assign_names.hpp"

#include <fmt/format.h>

#include <map>

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

namespace {

using NameCounts = std::map<std::string, int>;

NameCounts counts_of(const std::vector<std::string>& names) {
  NameCounts counts;
  for (const std::string& name : names) ++counts[name];
  return counts;
}

std::string numbered_name(const std::string& kind, std::size_t number, const NameCounts& taken) {
  const auto is_taken = [&](const std::string& name) {
    const auto entry = taken.find(name);
    return entry != taken.end() && entry->second > 0;
  };
  std::string name = fmt::format("{}_{}", kind, number);
  while (is_taken(name)) name += "_";
  return name;
}

}  // namespace

std::vector<int> replace_empty_names(std::vector<std::string>& names, const std::string& kind) {
  const NameCounts given = counts_of(names);
  std::vector<int> replaced;
  for (std::size_t i = 0; i < names.size(); ++i) {
    if (!names[i].empty()) continue;
    names[i] = numbered_name(kind, i, given);
    replaced.push_back(static_cast<int>(i));
  }
  return replaced;
}

std::vector<int> presumed_numbered_names(const std::vector<std::string>& names, const std::string& kind) {
  NameCounts others = counts_of(names);
  std::vector<int> presumed;
  for (std::size_t i = 0; i < names.size(); ++i) {
    --others[names[i]];
    if (names[i] == numbered_name(kind, i, others)) presumed.push_back(static_cast<int>(i));
    ++others[names[i]];
  }
  return presumed;
}

}  // namespace quadrille
