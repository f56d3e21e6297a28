#pragma once
// Runs one stage: in this process, in a child that is stopped when the budget is used up, or as an external program.

#include <chrono>
#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/run.hpp"
#include "chain/budget.hpp"
#include "chain/chain_options.hpp"
#include "chain/watched_child.hpp"
#include "io/chain_report.hpp"

namespace quadrille::chain {

/// A run of a stage that may be done in three ways.
struct StageTask {
  ChainStage stage = ChainStage::cad2tri;
  bool is_of_phase = false;                   ///< solves for prescribed nodes, as a part of separatrix
  std::vector<std::string> words = {};        ///< of its command: inputs and options
  std::string name = {};                      ///< in the report: the stage with a prefix, such as phase_fieldsolve
  std::string output = {};                    ///< path of the file that it writes
  std::function<void(Run&)> compute = {};     ///< here: keeps the result, and its file if files are kept
  std::function<void()> write_inputs = {};    ///< for an external program
  std::function<void()> drop_result = [] {};  ///< what is in memory, after another process wrote the file
};

struct StageEnd {
  ExitCode code = ExitCode::done;
  std::string message;      ///< of a failure
  std::string messages;     ///< what is to be printed of it, in whole lines
  bool is_stopped = false;  ///< by a limit, or killed by the system: `message` follows "STAGE was"
  io::StageReport report;
  bool lacks_memory = false;  ///< the reason of a failure
};

class StageRunner {
 public:
  /// `in_children`: each stage runs in a process of its own. `scratch`: a folder for temporary files.
  StageRunner(const ChainOptions& options, Budget budget, bool in_children, std::string scratch);

  /// Runs the task, which may use `share` of the budget. Messages of a failure are printed, but not with -q.
  StageEnd run(const StageTask& task, Share share);
  void print_messages(const StageEnd& end) const;

  /// Runs a command that makes an input of the chain, within the budget; returns its exit code and what it writes to
  /// standard error. A command that was stopped has the exit code 1, and the reason as its message.
  std::pair<int, std::string> run_helper(const std::vector<std::string>& words);

  /// Of all runs, in their order.
  std::vector<io::StageReport>& reports() { return reports_; }
  const std::vector<io::StageReport>& reports() const { return reports_; }
  const std::string& scratch() const { return scratch_; }
  /// Whether the result of a stage is read from its file.
  bool is_in_child(ChainStage stage) const;
  double seconds() const;  ///< since the start

 private:
  StageEnd run_here(const StageTask& task);
  StageEnd run_in_child(const StageTask& task, Share share);
  ChildEnd child_of(const StageTask& task, const std::string& report, Share share, std::string& errors);
  std::string progress_title(const StageTask& task) const;
  std::vector<std::string> command_of(const StageTask& task, const std::string& report) const;

  const ChainOptions& options_;
  Budget budget_;
  const bool in_children_;
  const std::string scratch_;
  const std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::vector<io::StageReport> reports_;
};

/// The words of the command for a person, or for an external program's shell.
std::vector<std::string> command_words(const StageTask& task, const ChainOptions& options);

}  // namespace quadrille::chain
