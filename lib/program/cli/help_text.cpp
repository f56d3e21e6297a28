#include <fmt/format.h>

#include "cli/command_line.hpp"

namespace quadrille::cli {

namespace {

/// `text` broken at blanks into lines of at most `width` bytes, each but the first indented.
std::string wrapped(const std::string& text, std::size_t indent, std::size_t width) {
  std::string out;
  std::size_t column = 0;
  for (std::size_t begin = 0; begin < text.size();) {
    std::size_t end = text.find_first_of(" \n", begin);
    if (end == std::string::npos) end = text.size();
    const std::string word = text.substr(begin, end - begin);
    if (column != 0 && column + 1 + word.size() > width) {
      out += '\n' + std::string(indent, ' ');
      column = 0;
    } else if (column != 0) {
      out += ' ';
      ++column;
    }
    out += word;
    column += word.size();
    if (end < text.size() && text[end] == '\n') {
      out += '\n' + std::string(indent, ' ');
      column = 0;
    }
    begin = end + 1;
  }
  return out;
}

const std::vector<HelpRow>& exit_codes() {
  static const std::vector<HelpRow> rows{
      {"0", "success"},
      {"1", "the input is well formed but has no valid result; the message states why and where"},
      {"2", "error on the command line"},
      {"3", "an input file cannot be read or breaks a rule of its format"},
      {"4", "the output could not be written"},
      {"70", "internal error, please report it"},
      {"128 + n", "terminated by signal n"}};
  return rows;
}

}  // namespace

std::string help_rows(const std::vector<HelpRow>& rows) {
  constexpr std::size_t indent = 28;
  std::string out;
  for (const HelpRow& row : rows) {
    out += "  " + row.left;
    if (row.left.size() + 4 > indent)
      out += '\n' + std::string(indent, ' ');
    else
      out += std::string(indent - 2 - row.left.size(), ' ');
    out += wrapped(row.right, indent, 100 - indent) + '\n';
  }
  return out;
}

std::string help_text(const HelpPage& page) {
  std::string out = fmt::format("Usage: {} [OPTIONS]{}\n\n{} {}.\n", page.name, page.synopsis, page.name,
                                wrapped(page.summary, 0, 80));
  if (!page.description.empty()) out += '\n' + wrapped(page.description, 0, 100) + '\n';
  if (!page.inputs.empty()) out += "\nINPUTS\n" + help_rows(page.inputs);
  if (!page.options.empty()) out += "\nOPTIONS\n" + help_rows(page.options);
  out += "\nOPTIONS OF EVERY COMMAND\n" + help_rows(page.common_options);
  out += "\nEXIT CODES\n" + help_rows(exit_codes());
  out += "\nEXAMPLES\n";
  for (const std::string& example : page.examples) out += "  " + example + '\n';
  return out;
}

}  // namespace quadrille::cli
