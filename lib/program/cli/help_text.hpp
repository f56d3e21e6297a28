#pragma once
// The text of --help. Private to cli.

#include <string>
#include <vector>

namespace quadrille::cli {

/// An input or option and its meaning.
struct HelpRow {
  std::string left;   ///< "--order N"
  std::string right;  ///< any length; broken into lines
};

struct HelpPage {
  std::string name, summary, description, synopsis;  ///< synopsis: the inputs, " [TRI]"
  std::vector<std::string> examples;
  std::vector<HelpRow> inputs, options, common_options;
};

/// Usage, summary, description, inputs, options, exit codes and examples, at most 100 columns wide.
std::string help_text(const HelpPage& page);

/// Rows in two columns, at most 100 columns wide.
std::string help_rows(const std::vector<HelpRow>& rows);

}  // namespace quadrille::cli
