#pragma once
// A stage in a process of its own, which is stopped with all that descend from it when the budget is used up.

#include <unistd.h>

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "chain/budget.hpp"

namespace quadrille::chain {

/// The exit code of a stopped stage; no tool has it.
inline constexpr int stopped_code = 124;

struct ChildEnd {
  int code = 0;  // exit code; 128 + n if signal n ended the process
  double cpu_seconds = 0, wall_seconds = 0;
  std::size_t memory = 0;                             // bytes that were resident, at most
  std::optional<std::string> stopped = std::nullopt;  // Budget::reason_to_stop
};

/// Runs `body` in a copy of this process, whose exit code is its value, and adds the run to the budget. If the budget
/// is used up, nothing is started, or the process is ended with all that descend from it: by TERM, and by KILL those
/// that remain after the grace of the budget. The copy has no signal handlers and gets TERM when this process ends. If
/// INT, TERM, HUP or QUIT arrive here meanwhile, the processes are ended likewise, and the signal is raised afterwards.
ChildEnd run_child(const std::function<int()>& body, Budget& budget, Share share);

struct Streams {
  int input = STDIN_FILENO;       // standard input of the command
  std::string* errors = nullptr;  // gets what the command writes to standard error, if not null
};

/// The same for a command: a program and its arguments. The code is 127 if it cannot be started, which is written to
/// standard error.
ChildEnd run_command(const std::vector<std::string>& words, const Streams& streams, Budget& budget, Share share);

// A process that outlives the work that it supervises, whatever ends that.

/// Makes the scratch folder, runs `work` in a copy of this process and returns its value. If the copy is killed, or
/// crashes, the scratch folder is emptied and another copy runs `work` with true. INT, TERM, HUP and QUIT are passed on
/// to the copy, whose end is awaited. Processes that a copy left are ended. `make_scratch` returns the path of the
/// folder, which is removed at the end; what it throws is thrown here. If a signal arrived here, or ended the last
/// copy, this process ends by the same signal. The copy gets TERM when this process ends.
int supervise(const std::function<int(bool is_second_try)>& work, const std::function<std::string()>& make_scratch);

}  // namespace quadrille::chain
