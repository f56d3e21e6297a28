#pragma once
// Times of the phases of a computation.

#include <ctime>
#include <string>
#include <vector>

namespace quadrille {

/// What a clock shows.
inline double seconds_of(clockid_t clock) {
  timespec t{};
  clock_gettime(clock, &t);
  return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
}

/// Seconds of one phase: CPU time of all threads of the process, and wall-clock time.
struct Lap {
  std::string phase;
  double cpu_seconds = 0, wall_seconds = 0;
};

class Stopwatch {
 public:
  /// Ends the phase that began at the last call, or at the construction of the stopwatch.
  void lap(const std::string& phase) {
    const double cpu = seconds_of(CLOCK_PROCESS_CPUTIME_ID), wall = seconds_of(CLOCK_MONOTONIC);
    laps_.push_back({phase, cpu - cpu_, wall - wall_});
    cpu_ = cpu;
    wall_ = wall;
  }
  const std::vector<Lap>& laps() const { return laps_; }

 private:
  double cpu_ = seconds_of(CLOCK_PROCESS_CPUTIME_ID), wall_ = seconds_of(CLOCK_MONOTONIC);
  std::vector<Lap> laps_;
};

}  // namespace quadrille
