#include "base/option_interval.hpp"

#include <fmt/format.h>

#include <limits>

#include "base/error.hpp"

namespace quadrille {

namespace {

template <typename T>
void require_within(const std::string& flag, T value, const std::string& text, T low, T high) {
  if (!(value >= low && value <= high))
    throw UsageError(fmt::format("{}: {} is outside its interval ({})", flag, text, interval_text(low, high)));
}

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

void IntervalCheck::integer(const std::string& flag, int& value, int low, int high, const std::string&) {
  require_within(flag, value, std::to_string(value), low, high);
}

}  // namespace quadrille
