#pragma once
// The frame of every command: options, help, exit codes, signals, report (lib/README.md, "Invariants").
// The only place that maps failures to exit codes, and the only folder that includes CLI11.

#include <functional>
#include <limits>
#include <string>
#include <vector>

#include "base/report.hpp"
#include "model/provenance.hpp"

namespace quadrille::cli {

/// Declares options. Variables hold their defaults on entry. Numbers outside [low, high] are usage errors; --help
/// states unit, default and interval. Every option declared here is recorded in the provenance unless `recorded` is
/// switched off for it (-o, -v, --threads, --report and the like are never recorded).
class Options {
 public:
  virtual ~Options() = default;
  virtual void input(const std::string& name, std::string& path, const std::string& help, bool required = false) = 0;
  /// All remaining positional arguments, at least one unless the default "-" is to be read.
  virtual void inputs(const std::string& name, std::vector<std::string>& paths, const std::string& help) = 0;
  virtual void output(std::string& path, const std::string& help) = 0;  ///< -o, --output
  virtual void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
                      const std::string& help) = 0;
  virtual void integer(const std::string& flag, int& value, int low, int high, const std::string& help) = 0;
  virtual void choice(const std::string& flag, std::string& value, const std::vector<std::string>& values,
                      const std::string& help) = 0;
  virtual void text(const std::string& flag, std::string& value, const std::string& placeholder,
                    const std::string& help, bool recorded = true) = 0;
  /// May be given several times; the values are kept in their sequence.
  virtual void texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
                     const std::string& help) = 0;
  virtual void flag(const std::string& flag, bool& value, const std::string& help) = 0;
};

/// What a running command may use besides its inputs.
class Session {
 public:
  Session(std::string tool, std::string options_json, int verbosity, int threads = 1);
  Report& report() { return report_; }
  /// Prints "tool: text" on stderr at -v.
  void say(const std::string& text) const;
  int verbosity() const { return verbosity_; }  ///< -1 quiet, 0, 1, 2
  int threads() const { return threads_; }      ///< how many may be used; results do not depend on it
  /// The chain `before` with this run's step appended.
  Provenance provenance(const Provenance& before, const std::vector<InputDigest>& inputs) const;
  const std::string& tool() const { return tool_; }
  /// Announces phases that begin later than `seconds` after the start (--progress).
  void show_progress_after(double seconds) { progress_after_ = seconds; }
  /// Starts the clock of a named phase; the report gets timings.<phase>.{cpu_seconds, wall_seconds}.
  void begin_phase(const std::string& name);
  void end_phase();
  /// Ends the last phase and sets timings.total: all CPU time of the process and its children, wall time of the run.
  void finish();

 private:
  std::string tool_, options_json_, phase_;
  int verbosity_ = 0, threads_ = 1;
  double phase_cpu_ = 0, phase_wall_ = 0, start_ = 0;
  double progress_after_ = std::numeric_limits<double>::infinity();
  Report report_;
};

struct Tool {
  std::string name;
  std::string summary;                ///< one line, starting with a verb: "finds the critical points of a field"
  std::string description;            ///< a paragraph or two for --help and the man page
  std::vector<std::string> examples;  ///< commands that run in a folder with the stage files of half_disc
  std::function<void(Options&)> options;
  std::function<void(Session&)> run;
  /// io/output_file's write_report; cli itself knows no files.
  std::function<void(const std::string& path, const std::string& tool, const std::string& version, const Report&)>
      report_writer;
};

/// Parses, runs, maps failures: prints "name: message" to stderr and returns the exit code (base/error.hpp).
int tool_main(int argc, char** argv, const Tool& tool);

/// The version of all tools, "0.1.0".
extern const char* const version;

}  // namespace quadrille::cli
