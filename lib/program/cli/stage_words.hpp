#pragma once
// The options of a stage for a program that runs several: their names, their help, their values from words.

#include <functional>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "cli/command_line.hpp"
#include "cli/run_files.hpp"

namespace quadrille::cli {

using Declare = std::function<void(Options&)>;

/// In the order of their declaration.
std::vector<OptionName> option_names(const Declare& declare);

/// Adds the files that the declared variables name.
void add_files(const Declare& declare, RunFiles& files);

/// The rows of --help.
std::string option_rows(const Declare& declare);

/// Sets the declared variables from words such as "--order", "6". Throws UsageError with the messages of a command.
void set_options(const Declare& declare, const std::vector<std::string>& words);

}  // namespace quadrille::cli
