#include "cad/name_options.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "base/error.hpp"
#include "base/name_text.hpp"

namespace quadrille::cad {
namespace {

std::vector<std::string> items_of(const std::string& list) {
  std::vector<std::string> items{""};
  for (const char c : list)
    if (c == ',')
      items.emplace_back();
    else
      items.back() += c;
  return items;
}

template <class Number>
std::optional<Number> number_of(const std::string& text) {
  Number number{};
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
  if (error != std::errc() || end != text.data() + text.size()) return std::nullopt;
  return number;
}

/// "4" or "3-6": the first number and the last; nothing for other texts.
std::optional<std::pair<int, int>> range_of(const std::string& item) {
  if (item.empty() || item.find_first_not_of("0123456789-") != std::string::npos) return std::nullopt;
  const std::size_t dash = item.find('-');
  const auto first = number_of<int>(item.substr(0, dash));
  const auto last = dash == std::string::npos ? first : number_of<int>(item.substr(dash + 1));
  if (!first || !last || *first < 0 || *last < *first) return std::nullopt;
  return std::pair{*first, *last};
}

NameRule rule_of_item(const std::string& item, const std::string& where) {
  NameRule rule;
  if (item.empty()) throw UsageError(where + ": an item of the list is empty");
  std::string_view pattern = item;
  for (const auto& [prefix, part] : {std::pair{std::string_view("boundary:"), NameRule::Part::boundary},
                                     std::pair{std::string_view("interface:"), NameRule::Part::interface}})
    if (pattern.starts_with(prefix)) rule.part = part, pattern.remove_prefix(prefix.size());
  if (pattern == "*") return rule;
  if (const auto range = range_of(item)) {
    rule.kind = NameRule::Kind::range;
    rule.number = range->first, rule.last_number = range->second;
  } else {
    rule.kind = NameRule::Kind::pattern;
    rule.text = pattern;
  }
  return rule;
}

NameRule rule_of_point(const std::string& point, const std::string& where) {
  NameRule rule;
  rule.kind = NameRule::Kind::position;
  rule.max_distance = max_option_distance;
  for (const std::string& item : items_of(point)) {
    const auto number = number_of<double>(item);
    if (!number || !std::isfinite(*number)) throw UsageError(where + ": a point is X,Y or X,Y,Z, in file units");
    rule.position.push_back(*number);
  }
  if (rule.position.size() < 2 || rule.position.size() > 3)
    throw UsageError(where + ": a point is X,Y or X,Y,Z, in file units");
  return rule;
}

}  // namespace

std::vector<NameRule> name_option_rules(const std::vector<std::string>& options, const std::string& option_name) {
  std::vector<NameRule> rules;
  for (const std::string& option : options) {
    const std::string where = fmt::format("{} {}", option_name, option);
    const std::size_t end = option.find_first_of("=@");
    const std::string name = end == std::string::npos ? "" : clean_name(option.substr(0, end));
    if (name.empty())
      throw UsageError(where + ": expected NAME=LIST, such as hole=4 or wall=1,3-6 or wall=edge_*, or NAME@X,Y");
    const std::string target = option.substr(end + 1);
    const auto add = [&](NameRule rule) {
      rule.name = name, rule.where = where;
      rules.push_back(std::move(rule));
    };
    if (option[end] == '@')
      add(rule_of_point(target, where));
    else
      for (const std::string& item : items_of(target)) add(rule_of_item(item, where));
  }
  return rules;
}

}  // namespace quadrille::cad
