#include "cli/option_values.hpp"

#include <fmt/format.h>

#include <charconv>

#include "base/error.hpp"
#include "base/options.hpp"

namespace quadrille::cli {

namespace {

/// The whole of `text` as a number; a leading + is allowed.
template <typename T>
bool parse_number(const std::string& text, T& value) {
  const char* const begin = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* const end = text.c_str() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && begin != end;
}

}  // namespace

double number_within(const std::string& flag, const std::string& text, double low, double high) {
  double given = 0;
  if (!parse_number(text, given)) throw UsageError(fmt::format("{}: '{}' is not a number", flag, text));
  require_in_interval(flag, given, text, low, high);
  return given;
}

int integer_within(const std::string& flag, const std::string& text, int low, int high) {
  int given = 0;
  if (!parse_number(text, given)) throw UsageError(fmt::format("{}: '{}' is not an integer", flag, text));
  require_in_interval(flag, given, text, low, high);
  return given;
}

int threads_of(const std::string& text) { return text == "auto" ? 0 : integer_within("--threads", text, 1, 1024); }

}  // namespace quadrille::cli
