#include "io/name_rules_io.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "io/json_archive.hpp"

namespace quadrille::io {

namespace {

using Json = nlohmann::ordered_json;

struct Dialect {
  const char* position_key;
  bool has_old_names;
};
constexpr Dialect boundary_names{"near", true}, block_names{"at", false};

Json parsed_rules(const InputFile& file) {
  require_shallow(file.bytes, file.name);
  std::set<std::string> keys;
  const auto refuse_twins = [&](int depth, Json::parse_event_t event, Json& value) {
    if (depth > 0 && event == Json::parse_event_t::object_start)
      throw FormatError(file.name + ": the new name must be a text that is not empty, not an object");
    if (depth == 1 && event == Json::parse_event_t::key && !keys.insert(value.get<std::string>()).second)
      throw FormatError(fmt::format("{}: the key \"{}\" occurs twice", file.name, value.get<std::string>()));
    return true;
  };
  try {
    // The parser looks at all members of a list after each one where it calls a function.
    const std::size_t first = file.bytes.find_first_not_of(" \t\r\n");
    const bool is_object = first != std::string::npos && file.bytes[first] == '{';
    return is_object ? Json::parse(file.bytes, refuse_twins) : Json::parse(file.bytes);
  } catch (const Json::parse_error& e) {
    throw FormatError(fmt::format("{}: not JSON (byte {})", file.name, e.byte));
  } catch (const Json::out_of_range&) {
    throw FormatError(fmt::format("{}: a number is larger than the largest of double precision", file.name));
  }
}

std::string new_name(const Json& value, const std::string& where) {
  std::string name = value.is_string() ? clean_name(value.get<std::string>()) : std::string();
  if (name.empty()) throw FormatError(where + ": the new name must be a text that is not empty");
  return name;
}

/// "*", or of boundary curves "interface:*".
std::optional<NameRule> rule_of_rest(const std::string& key, const Dialect& dialect) {
  NameRule rule;
  if (key == "interface:*" && dialect.has_old_names)
    rule.part = NameRule::Part::interface;
  else if (key != "*")
    return std::nullopt;
  return rule;
}

NameRule rule_of_key(const std::string& key, const Dialect& dialect, const std::string& where) {
  if (const auto rest = rule_of_rest(key, dialect)) return *rest;
  NameRule rule;
  rule.text = key;
  const std::optional<int> number = number_of<int>(key);
  rule.number = number.value_or(-1);
  if (!number && !dialect.has_old_names) throw FormatError(where + ": must be the number of a block, or \"*\"");
  rule.kind = dialect.has_old_names ? NameRule::Kind::key : NameRule::Kind::number;
  return rule;
}

NameRule rule_of_id(const Json& id, const Dialect& dialect, const std::string& where) {
  if (id.is_string())
    if (const auto rest = rule_of_rest(id.get<std::string>(), dialect)) return *rest;
  NameRule rule;
  if (!id.is_number_integer()) throw FormatError(where + ": \"id\" must be an integer, or \"*\" for all others");
  rule.kind = NameRule::Kind::number;
  rule.number = id.is_number_unsigned() && id.get<std::uint64_t>() <= 0x7FFFFFFF ? id.get<int>() : -1;
  return rule;
}

NameRule rule_of_position(const Json& position, const char* key, const std::string& where) {
  NameRule rule;
  rule.kind = NameRule::Kind::position;
  if (position.is_array())
    for (const Json& x : position)
      if (x.is_number()) rule.position.push_back(x.get<double>());
  const std::size_t size = rule.position.size();
  if (size != position.size() || size < 2 || size > 3)
    throw FormatError(fmt::format("{}: \"{}\" must be [x, y] or [x, y, z]", where, key));
  for (const double x : rule.position)
    if (!std::isfinite(x)) throw FormatError(fmt::format("{}: \"{}\" is not finite", where, key));
  return rule;
}

/// An entry must have exactly one key that selects, the key `name`, and no other.
NameRule rule_of_entry(const Json& entry, const Dialect& dialect, const std::string& where) {
  std::vector<std::string> keys{"id", dialect.position_key};
  if (dialect.has_old_names) keys.push_back("old_name");
  const std::string expected = fmt::format(R"(one of "{}", and "name")", fmt::join(keys, R"(", ")"));
  if (!entry.is_object() || entry.size() != 2 || !entry.contains("name"))
    throw FormatError(fmt::format("{}: must be an object with {}", where, expected));
  NameRule rule;
  for (const auto& [key, value] : entry.items()) {
    if (key == "name") continue;
    if (key == "id") {
      rule = rule_of_id(value, dialect, where);
    } else if (key == dialect.position_key) {
      rule = rule_of_position(value, dialect.position_key, where);
    } else if (dialect.has_old_names && key == "old_name" && value.is_string()) {
      rule.kind = NameRule::Kind::old_name;
      rule.text = value.get<std::string>();
    } else {
      throw FormatError(fmt::format("{}: \"{}\" is not {}", where, key, expected));
    }
  }
  rule.name = new_name(entry["name"], where);
  return rule;
}

std::vector<NameRule> rules_of(const InputFile& file, const Dialect& dialect) {
  const Json json = parsed_rules(file);
  std::vector<NameRule> rules;
  const auto add = [&](NameRule rule, const std::string& name, const std::string& where) {
    rule.name = name, rule.where = where;
    rules.push_back(std::move(rule));
  };
  if (json.is_string()) {
    add({}, new_name(json, file.name), file.name);
  } else if (json.is_object()) {
    for (const auto& [key, value] : json.items()) {
      const std::string where = fmt::format("{}: \"{}\"", file.name, key);
      add(rule_of_key(key, dialect, where), new_name(value, where), where);
    }
  } else if (json.is_array()) {
    for (const Json& entry : json) {
      const std::string where = fmt::format("{}: entry {}", file.name, rules.size());
      const NameRule rule = rule_of_entry(entry, dialect, where);
      add(rule, rule.name, where);
    }
  } else {
    throw FormatError(file.name + ": must be a text, an object or a list");
  }
  return rules;
}

}  // namespace

std::vector<NameRule> read_boundary_names(const InputFile& file) { return rules_of(file, boundary_names); }
std::vector<NameRule> read_block_names(const InputFile& file) { return rules_of(file, block_names); }

}  // namespace quadrille::io
