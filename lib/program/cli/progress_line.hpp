#pragma once
// The line on standard error that shows how far a run is (--progress).

#include <functional>
#include <mutex>
#include <string>
#include <thread>
#include <vector>

#include "base/progress.hpp"

namespace quadrille::cli {

/// How and when progress is shown.
struct ProgressStyle {
  bool is_terminal = false;   ///< one line that is overwritten and at last erased; else a new line for each state
  double delay = 1;           ///< seconds of work before anything is shown
  std::string title;          ///< at the start of the line: "padapt"
  double seconds_before = 0;  ///< of work, before this process: of the earlier stages of a pipeline
  std::vector<std::string> hidden_phases;  ///< nothing is shown during these; work begins with the first other one

  double interval() const { return is_terminal ? 0.2 : 10; }  ///< seconds between two states
};

/// The text of a state: "title: phase, solutions 3 of at most 20, elements 43 %, 12 s".
std::string progress_text(const std::string& title, const std::string& phase,
                          const std::vector<Progress::Count>& counts, double seconds);

/// Every function may be called from any thread.
class ProgressLine {
 public:
  using Write = std::function<void(const std::string&)>;

  /// `progress` must outlive this. `write` is called with what is to be written to standard error.
  ProgressLine(const Progress& progress, ProgressStyle style, Write write);
  ~ProgressLine() { end_phase(); }
  ProgressLine(const ProgressLine&) = delete;
  ProgressLine& operator=(const ProgressLine&) = delete;

  void begin_phase(const std::string& name);
  void end_phase();
  /// Shows the present state, if anything is to be shown now.
  void update();
  /// Writes a line of text; on a terminal above that of the progress.
  void print(const std::string& text);

 private:
  double seconds() const;  ///< of work
  bool is_due() const;     ///< whether there is anything to show now
  void draw();
  void erase();

  const Progress& progress_;
  const ProgressStyle style_;
  const Write write_;
  std::mutex mutex_;
  std::string phase_;       ///< empty: nothing is shown
  double work_begin_ = -1;  ///< of the clock, seconds; negative: it has not begun
  std::string shown_;       ///< the text of the last state
};

/// Updates a line in intervals, as long as this exists.
class ProgressTicker {
 public:
  ProgressTicker(ProgressLine& line, double interval);

 private:
  std::jthread thread_;
};

/// Erases the line on the terminal, for handlers of signals that end the process: async-signal-safe.
void erase_progress_line() noexcept;

}  // namespace quadrille::cli
