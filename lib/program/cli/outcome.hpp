#pragma once
// What work ended with: an exit code and, if it failed, a message. The only code that maps failures to exit codes.

#include <functional>
#include <string>
#include <vector>

#include "base/error.hpp"

namespace quadrille::cli {

struct Outcome {
  ExitCode code = ExitCode::done;
  std::string message;
  bool lacks_memory = false;  ///< the reason of the failure

  bool is_success() const { return code == ExitCode::done; }
};

/// Runs `work`; any exception becomes an exit code (base/error.hpp).
Outcome outcome_of(const std::function<void()>& work);

/// "name: message" and, after a mistake on the command line, how to get help: whole lines.
std::string error_text(const std::string& name, const Outcome& outcome);

/// Prints that text if the work failed; the exit code of the process.
int print_failure(const std::string& name, const Outcome& outcome);

// What a command line asks for instead of work: one rule for all commands (that of Python is in
// pipelines/lib/command_frame.py).

enum class Request { run, show_help, show_version, list_options };

/// That of the first word that is --help, -h (also among letters, as in -vh), --help-all (the same but for quadmesh),
/// --version or --list-options, wherever it stands: no other word is then read, so that none is refused.
Request request_of(const std::vector<std::string>& words);

/// Prints what is asked for of the command `name`, or nothing if it shall run. Throws OutputError.
void answer(Request request, const std::string& name, const std::function<std::string()>& help,
            const std::function<std::string()>& options);

}  // namespace quadrille::cli
