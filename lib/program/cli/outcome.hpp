#pragma once
// What work ended with: an exit code and, if it failed, a message. The only code that maps failures to exit codes.

#include <functional>
#include <string>

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

}  // namespace quadrille::cli
