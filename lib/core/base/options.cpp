#include "base/options.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <limits>

#include "base/error.hpp"
#include "base/message_text.hpp"

namespace quadrille {

namespace {

template <typename T>
void require_within(const std::string& flag, T value, const std::string& text, T low, T high) {
  if (!(value >= low && value <= high))
    throw UsageError(fmt::format("{}: {} is outside its interval ({})", flag, text, interval_text(low, high)));
}

/// The fewest digits that read back to the same bits, as stage files have them: what is exported from memory and from a
/// file is the same.
std::string shortest(double value) { return fmt::format("{}", value); }

}  // namespace

std::string interval_text(double low, double high) {
  constexpr double boundless = 1e300;
  const bool open_above = high >= boundless;
  if (low <= -boundless) return open_above ? "any number" : fmt::format("at most {}", high);
  return open_above ? fmt::format("at least {}", low) : fmt::format("{} to {}", low, high);
}

std::string interval_text(int low, int high) {
  return high == std::numeric_limits<int>::max() ? fmt::format("at least {}", low) : fmt::format("{} to {}", low, high);
}

void require_in_interval(const std::string& flag, double value, const std::string& text, double low, double high) {
  require_within(flag, value, text, low, high);
}

void require_in_interval(const std::string& flag, int value, const std::string& text, int low, int high) {
  require_within(flag, value, text, low, high);
}

void IntervalCheck::number(const std::string& flag, double& value, double low, double high, const std::string&,
                           const std::string&) {
  require_within(flag, value, fmt::format("{}", value), low, high);
}

void IntervalCheck::optional_number(const std::string& flag, std::optional<double>& value, double low, double high,
                                    const std::string& unit, const std::string& help) {
  if (value) number(flag, *value, low, high, unit, help);
}

void IntervalCheck::integer(const std::string& flag, int& value, int low, int high, const std::string&) {
  require_within(flag, value, std::to_string(value), low, high);
}

void OptionRecord::record(const std::string& flag, std::function<std::string()> value) {
  values_[flag.substr(flag.rfind("--") + 2)] = std::move(value);
}

void OptionRecord::number(const std::string& flag, double& value, double, double, const std::string&,
                          const std::string&) {
  record(flag, [&value] { return std::isfinite(value) ? shortest(value) : std::string("null"); });
}

void OptionRecord::optional_number(const std::string& flag, std::optional<double>& value, double, double,
                                   const std::string&, const std::string&) {
  record(flag, [&value] { return value ? shortest(*value) : std::string("null"); });
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
  record(flag, [get] { return get().empty() ? "false" : json_string(get()); });
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
