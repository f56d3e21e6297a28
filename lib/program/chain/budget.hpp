#pragma once
// Limits of the time and memory of all stages together. Both the CPU seconds of all runs, threads and child processes
// included, and the seconds since the start are limited. The memory is what is resident or swapped out, not what is
// reserved: CAD kernels and threads reserve far more than they use.

#include <chrono>
#include <cstddef>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "chain/process_tree.hpp"

namespace quadrille::chain {

struct Limits {
  std::optional<double> seconds = std::nullopt;
  std::optional<std::size_t> memory = std::nullopt;  // bytes
  double grace = 1;  // seconds in which a stopped process can remove its temporary files
};

/// The value of --max-seconds. Throws UsageError unless it is a positive number.
double parse_max_seconds(const std::string& text);
/// The value of --max-memory in bytes: a positive number, with K, M, G or T (powers of 1024) behind it or not.
std::size_t parse_max_memory(const std::string& text);
/// A number of bytes in the unit in which it has at most four digits: "500M".
std::string size_text(std::size_t bytes);

/// The seconds that a stage may use: all, or most: then some are kept for quads that are made from triangles alone.
enum class Share { all, most };

/// What a run used. `wall_seconds` are elapsed seconds.
struct Used {
  double cpu_seconds = 0, wall_seconds = 0;
};

class Budget {
 public:
  using Clock = std::chrono::steady_clock;

  /// `runs` are those before; the first run is that of the triangles.
  explicit Budget(Limits limits = {}, Clock::time_point start = Clock::now(), std::vector<Used> runs = {})
      : limits_(limits), start_(start), runs_(std::move(runs)) {}

  const Limits& limits() const { return limits_; }
  bool is_limited() const { return limits_.seconds || limits_.memory; }
  const std::vector<Used>& runs() const { return runs_; }
  void add_run(Used run) { runs_.push_back(run); }
  /// Of a command beside the stages, such as points2step: it counts, but is not that of the triangles.
  void add_helper(Used run) { helper_cpu_seconds_ += run.cpu_seconds; }
  /// What the last run used for other work, as a helper's: the chart of a curved face, which comes before its
  /// triangles.
  void move_to_helper(Used part) {
    Used& run = runs_.back();
    run.cpu_seconds -= part.cpu_seconds, run.wall_seconds -= part.wall_seconds;
    add_helper(part);
  }
  /// Limits of the CPU seconds of all runs and of the seconds from the start. Needs a limit of seconds.
  Used limits_of(Share share) const;
  /// Nothing, or the reason, which follows "TOOL was": "stopped after 3.10 s of all stages: --max-seconds is 3".
  /// Without the processes of a run, before its start: "not started after ...".
  std::optional<std::string> reason_to_stop(Share share, const ProcessTree* run) const;
  /// The reason for a run that has used `bytes` and got no more. Needs a limit of memory.
  std::string reason_of_memory(std::size_t bytes) const;

 private:
  std::optional<std::string> reason_of_time(Share share, const ProcessTree* run) const;

  Limits limits_;
  Clock::time_point start_;
  std::vector<Used> runs_;
  double helper_cpu_seconds_ = 0;
};

}  // namespace quadrille::chain
