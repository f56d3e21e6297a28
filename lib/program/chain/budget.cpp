#include "chain/budget.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <numeric>
#include <string_view>
#include <system_error>

#include "base/error.hpp"

namespace quadrille::chain {
namespace {

// What is kept: this share of the seconds, and this many times those of the triangles. Quads from triangles took 2.6 to
// 4 times as long as the triangles, on real faces and on plates with up to 144 holes.
constexpr double kept_share = 0.25;
constexpr double kept_times = 5;

constexpr std::string_view units = "KMGT";  // powers of 1024
constexpr double most_bytes = 0x1p62;       // so that the number of bytes fits its type

double bytes_in(std::size_t unit) { return static_cast<double>(std::size_t{1} << 10 * (unit + 1)); }

double positive(std::string_view option, std::string_view text, std::string_view kind) {
  double value = 0;
  const auto [end, error] = std::from_chars(text.begin(), text.end(), value);
  if (error == std::errc::invalid_argument || end != text.end())
    throw UsageError(fmt::format("{}: '{}' is not {}", option, text, kind));
  if (error != std::errc() || !(value > 0) || std::isinf(value))
    throw UsageError(fmt::format("{}: {} is outside its interval (above 0)", option, text));
  return value;
}

}  // namespace

double parse_max_seconds(const std::string& text) { return positive("--max-seconds", text, "a number"); }

std::size_t parse_max_memory(const std::string& text) {
  const auto unit = text.empty() ? std::string_view::npos
                                 : units.find(static_cast<char>(std::toupper(static_cast<unsigned char>(text.back()))));
  const bool has_unit = unit != std::string_view::npos;
  const std::string_view number(text.data(), text.size() - (has_unit ? 1 : 0));
  const double value = positive("--max-memory", number, "a size") * (has_unit ? bytes_in(unit) : 1);
  return static_cast<std::size_t>(std::min(value, most_bytes));
}

std::string size_text(std::size_t bytes) {
  const auto size = static_cast<double>(bytes);
  std::size_t unit = 0;
  while (unit + 1 < units.size() && size >= 10000 * bytes_in(unit)) ++unit;
  return fmt::format("{:.0f}{}", size / bytes_in(unit), units[unit]);
}

Used Budget::limits_of(Share share) const {
  const double seconds = *limits_.seconds;
  if (share == Share::all) return {seconds, seconds};
  const Used triangles = runs_.empty() ? Used{} : runs_.front();
  const auto rest = [&](double taken) { return seconds - std::max(kept_share * seconds, kept_times * taken); };
  return {rest(triangles.cpu_seconds), rest(triangles.wall_seconds)};
}

std::optional<std::string> Budget::reason_of_time(Share share, const ProcessTree* run) const {
  const auto add = [](double sum, const Used& used) { return sum + used.cpu_seconds; };
  const double present = helper_cpu_seconds_ + (run ? run->cpu_seconds() : 0.0);
  const double cpu = std::accumulate(runs_.begin(), runs_.end(), present, add);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start_).count();
  const Used most = limits_of(share);
  if (cpu <= most.cpu_seconds && elapsed <= most.wall_seconds) return std::nullopt;
  return fmt::format(
      "{} after {} of all stages: --max-seconds is {:g}{}", run ? "stopped" : "not started",
      cpu > most.cpu_seconds ? fmt::format("{:.2f} s of CPU time", cpu) : fmt::format("{:.2f} s", elapsed),
      *limits_.seconds, share == Share::most ? ", and the rest is kept for quads without a field" : "");
}

std::optional<std::string> Budget::reason_to_stop(Share share, const ProcessTree* run) const {
  if (limits_.seconds)
    if (auto reason = reason_of_time(share, run)) return reason;
  const std::size_t memory = limits_.memory && run ? run->memory() : 0;
  if (!limits_.memory || memory <= *limits_.memory) return std::nullopt;
  return reason_of_memory(memory);
}

std::string Budget::reason_of_memory(std::size_t bytes) const {
  return fmt::format("stopped at {} of memory{}: --max-memory is {}", size_text(bytes),
                     bytes > *limits_.memory ? "" : ", because it needed more", size_text(*limits_.memory));
}

}  // namespace quadrille::chain
