#include "cli/session.hpp"

#include <fmt/format.h>
#include <sys/resource.h>

#include "base/name_text.hpp"
#include "base/parallel.hpp"
#include "base/stopwatch.hpp"
#include "base/version.hpp"
#include "cli/messages.hpp"

namespace quadrille::cli {

namespace {

/// User and system time of this process and of the children that it waited for.
double cpu_seconds() {
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  rusage self{}, children{};
  getrusage(RUSAGE_SELF, &self);
  getrusage(RUSAGE_CHILDREN, &children);
  return seconds(self.ru_utime) + seconds(self.ru_stime) + seconds(children.ru_utime) + seconds(children.ru_stime);
}

}  // namespace

Session::Session(std::string tool, std::string options_json, int verbosity, int threads)
    : tool_(std::move(tool)),
      options_json_(std::move(options_json)),
      verbosity_(verbosity),
      threads_(threads),
      start_(seconds_of(CLOCK_MONOTONIC)) {}

void Session::info(const std::string& text, int level) const {
  if (verbosity_ < level) return;
  if (display_.line)
    display_.line->print(printable_text(tool_ + ": " + text));
  else
    print_message(fmt::format("{}: {}\n", tool_, text));
}

void Session::show_progress(const ProgressStyle& style) {
  report_ = Report(&display_.progress);
  display_.line.emplace(display_.progress, style, write_to_terminal);
  display_.ticker.emplace(*display_.line, style.interval());
}

int Session::threads() const { return threads_ > 0 ? threads_ : available_processors(); }

Provenance Session::provenance(const Provenance& before, const std::vector<InputDigest>& inputs) const {
  Provenance chain = before;
  chain.push_back({tool_, version, inputs, options_json_});
  return chain;
}

void Session::begin_phase(const std::string& name) {
  end_phase();
  phase_ = {name, cpu_seconds(), seconds_of(CLOCK_MONOTONIC)};
  if (display_.line) display_.line->begin_phase(name);
}

void Session::leave_out_earlier_work() { cpu_start_ = cpu_seconds(); }

void Session::finish() {
  end_phase();
  display_.ticker.reset();
  display_.line.reset();
  report_.set("timings.total.cpu_seconds", cpu_seconds() - cpu_start_);
  report_.set("timings.total.wall_seconds", seconds_of(CLOCK_MONOTONIC) - start_);
}

void Session::end_phase() {
  if (phase_.name.empty()) return;
  if (display_.line) display_.line->end_phase();
  const double cpu = cpu_seconds() - phase_.cpu;
  const double wall = seconds_of(CLOCK_MONOTONIC) - phase_.wall;
  report_.set("timings." + phase_.name + ".cpu_seconds", cpu);
  report_.set("timings." + phase_.name + ".wall_seconds", wall);
  info(fmt::format("{}: {:.1f} ms", phase_.name, 1e3 * wall), 2);
  phase_.name.clear();
}

}  // namespace quadrille::cli
