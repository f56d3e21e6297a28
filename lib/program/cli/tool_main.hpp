#pragma once
// The frame of every command: options, help, exit codes, signals, report (lib/README.md, "Invariants"). The only code
// that maps failures to exit codes, and the only folder that includes CLI11.

#include <functional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "cli/run_files.hpp"
#include "cli/session.hpp"

namespace quadrille::cli {

struct Tool {
  std::string name;
  std::string summary;                ///< one line, starting with a verb: "finds the critical points of a field"
  std::string description;            ///< a paragraph or two for --help and the man page
  std::vector<std::string> examples;  ///< commands that run in a folder with the stage files of half_disc
  std::function<void(Options&)> options;
  /// Adds files beside those that the options name.
  std::function<void(RunFiles&)> files;
  std::function<void(Session&)> run;
  /// io/whole_file's write_report; cli itself does not access files.
  std::function<void(const std::string& path, const std::string& tool, const std::string& version, const Report&)>
      report_writer;
};

/// Parses, runs, maps failures: prints "name: message" to standard error and returns the exit code (base/error.hpp).
int tool_main(int argc, char** argv, const Tool& tool);

}  // namespace quadrille::cli
