#include "base/option_record.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

#include "base/json_string.hpp"

namespace quadrille {

void OptionRecord::record(const std::string& flag, std::function<std::string()> value) {
  values_[flag.substr(flag.rfind("--") + 2)] = std::move(value);
}

void OptionRecord::number(const std::string& flag, double& value, double, double, const std::string&,
                          const std::string&) {
  record(flag, [&value] { return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string("null"); });
}

void OptionRecord::integer(const std::string& flag, int& value, int, int, const std::string&) {
  record(flag, [&value] { return std::to_string(value); });
}

void OptionRecord::text(const std::string& flag, std::string& value, const std::string&, const std::string&,
                        bool recorded) {
  if (recorded) record(flag, [&value] { return json_string(value); });
}

void OptionRecord::texts(const std::string& flag, std::vector<std::string>& values, const std::string&,
                         const std::string&, bool records_none) {
  record(flag, [&values, records_none] {
    if (values.empty() && !records_none) return std::string();
    std::vector<std::string> quoted;
    for (const std::string& value : values) quoted.push_back(json_string(value));
    return fmt::format("[{}]", fmt::join(quoted, ","));
  });
}

void OptionRecord::flag(const std::string& flag, bool& value, const std::string&) {
  record(flag, [&value] { return std::string(value ? "true" : "false"); });
}

void OptionRecord::one_of(const std::string& flag, const std::vector<std::string>&,
                          const std::function<std::string()>& get, const std::function<void(const std::string&)>&,
                          const std::string&) {
  record(flag, [get] { return json_string(get()); });
}

std::string OptionRecord::json() const {
  std::string out = "{";
  for (const auto& [key, value] : values_) {
    const std::string json = value();
    if (json.empty()) continue;
    if (out.size() > 1) out += ',';
    out += json_string(key) + ':' + json;
  }
  return out + "}";
}

}  // namespace quadrille
