#pragma once
// What a command line asks for instead of work: one rule for all commands (that of Python is in
// pipelines/lib/command_frame.py).

#include <functional>
#include <string>
#include <vector>

namespace quadrille::cli {

enum class Request { run, show_help, show_version, list_options };

/// That of the first word that is --help, -h (also among letters, as in -vh), --version or --list-options, wherever it
/// stands: no other word is then read, so that none is refused.
Request request_of(const std::vector<std::string>& words);

/// Prints what is asked for of the command `name`, or nothing if it shall run. Throws OutputError.
void answer(Request request, const std::string& name, const std::function<std::string()>& help,
            const std::function<std::string()>& options);

}  // namespace quadrille::cli
