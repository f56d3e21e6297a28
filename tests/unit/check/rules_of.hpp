#pragma once
// Which rules a stage breaks: for tests that break exactly one.

#include <set>
#include <string>
#include <vector>

#include "check/check.hpp"

namespace quadrille::check {

inline std::set<std::string> rules_of(const std::vector<Violation>& violations) {
  std::set<std::string> rules;
  for (const Violation& violation : violations) rules.insert(violation.rule);
  return rules;
}

using Rules = std::set<std::string>;

/// The rules that `stage` breaks after `damage` has changed it.
template <typename Stage, typename Damage>
Rules broken_rules(Stage stage, const Damage& damage) {
  damage(stage);
  return rules_of(check_stage(stage, CheckDepth::full));
}

}  // namespace quadrille::check
