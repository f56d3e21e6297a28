#include <fmt/format.h>
#include <sys/resource.h>

#include <cstdio>
#include <ctime>

#include "cli/tool_main.hpp"

namespace quadrille::cli {

namespace {

double wall_seconds() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

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
      start_(wall_seconds()) {}

void Session::say(const std::string& text) const {
  if (verbosity_ >= 1) fmt::print(stderr, "{}: {}\n", tool_, text);
}

Provenance Session::provenance(const Provenance& before, const std::vector<InputDigest>& inputs) const {
  Provenance chain = before;
  chain.push_back({tool_, version, inputs, options_json_});
  return chain;
}

void Session::begin_phase(const std::string& name) {
  end_phase();
  phase_ = name;
  phase_cpu_ = cpu_seconds();
  phase_wall_ = wall_seconds();
  if (phase_wall_ - start_ >= progress_after_) fmt::print(stderr, "{}: {} ...\n", tool_, phase_);
}

void Session::finish() {
  end_phase();
  report_.set("timings.total.cpu_seconds", cpu_seconds());
  report_.set("timings.total.wall_seconds", wall_seconds() - start_);
}

void Session::end_phase() {
  if (phase_.empty()) return;
  const double cpu = cpu_seconds() - phase_cpu_;
  const double wall = wall_seconds() - phase_wall_;
  report_.set("timings." + phase_ + ".cpu_seconds", cpu);
  report_.set("timings." + phase_ + ".wall_seconds", wall);
  if (verbosity_ >= 2) fmt::print(stderr, "{}: {}: {:.1f} ms\n", tool_, phase_, 1e3 * wall);
  phase_.clear();
}

}  // namespace quadrille::cli
