#pragma once
// The services of a running command: the report, messages, timings, the provenance of its output.

#include <optional>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/run.hpp"
#include "cli/progress_line.hpp"
#include "model/provenance.hpp"

namespace quadrille::cli {

class Session : public Run {
 public:
  /// `threads` 0: as many as there are processors.
  Session(std::string tool, std::string options_json, int verbosity, int threads = 1);
  /// Prints "tool: text" on standard error if the verbosity is at least `level` (-v: 1, -v -v: 2).
  void info(const std::string& text, int level = 1) const override;
  int threads() const override;
  /// The chain `before` with the step of this run appended.
  Provenance provenance(const Provenance& before, const std::vector<InputDigest>& inputs) const;
  /// Shows how far the run is (--progress). To be called before the work.
  void show_progress(const ProgressStyle& style);
  /// From now on, the total of CPU time does not contain what this process used before: it ran other stages.
  void leave_out_earlier_work();
  /// Starts the clock of a named phase; the report gets timings.<phase>.{cpu_seconds, wall_seconds}.
  void begin_phase(const std::string& name) override;
  void end_phase() override;
  /// Ends the last phase and sets timings.total: all CPU time of the process and its children, wall time of the run.
  void finish();

 private:
  struct Phase {
    std::string name;          ///< empty: none is running
    double cpu = 0, wall = 0;  ///< seconds at its start
  };
  std::string tool_, options_json_;
  int verbosity_ = 0, threads_ = 1;
  double start_ = 0;      ///< of the run, seconds
  double cpu_start_ = 0;  ///< CPU time that does not count, seconds
  Phase phase_;
  /// How far the run is. The ticker ends before the line that it writes.
  struct Display {
    Progress progress;
    mutable std::optional<ProgressLine> line;  ///< none: it is not shown; messages are written above it
    std::optional<ProgressTicker> ticker;
  };
  Display display_;
};

}  // namespace quadrille::cli
