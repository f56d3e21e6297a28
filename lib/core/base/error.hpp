#pragma once
// Error types, one for each exit code that a user can meet (formats/README.md, "Exit codes"). Library code throws them;
// only cli/outcome turns them into messages and codes. A message states what is wrong and where, in a user's words,
// without the tool's name and without a final full stop.

#include <stdexcept>
#include <string>

namespace quadrille {

enum class ExitCode : int { done = 0, no_result = 1, usage = 2, bad_input = 3, bad_output = 4, defect = 70 };

class Error : public std::runtime_error {
 public:
  Error(ExitCode code, const std::string& message) : std::runtime_error(message), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

/// Well-formed input that has no valid result: exit 1.
struct ComputeError : Error {
  explicit ComputeError(const std::string& message) : Error(ExitCode::no_result, message) {}
};

/// A mistake on the command line: exit 2.
struct UsageError : Error {
  explicit UsageError(const std::string& message) : Error(ExitCode::usage, message) {}
};

/// Anything wrong with an input file, CAD topology included: exit 3. `rule` names a numbered rule (TRI-R01) or is
/// empty.
struct FormatError : Error {
  explicit FormatError(const std::string& message, std::string broken_rule = {})
      : Error(ExitCode::bad_input, broken_rule.empty() ? message : broken_rule + ": " + message),
        rule(std::move(broken_rule)) {}
  std::string rule;
};

/// The output could not be written: exit 4.
struct OutputError : Error {
  explicit OutputError(const std::string& message) : Error(ExitCode::bad_output, message) {}
};

/// An internal contradiction: exit 70. Never thrown for a condition that an input can cause.
struct Defect : Error {
  explicit Defect(const std::string& message) : Error(ExitCode::defect, message) {}
};

}  // namespace quadrille
