#include "chain/shape_converters.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cctype>
#include <sstream>
#include <utility>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "chain/chain_state.hpp"
#include "chain/end_of_run.hpp"
#include "cli/messages.hpp"
#include "io/whole_file.hpp"

namespace quadrille::chain {

namespace {

const ShapeConverter* converter_by_ending(std::string shape) {
  std::transform(shape.begin(), shape.end(), shape.begin(), [](unsigned char c) { return std::tolower(c); });
  for (const ShapeConverter& converter : shape_converters())
    for (const std::string& ending : converter.endings)
      if (shape.ends_with(ending)) return &converter;
  return nullptr;
}

/// The warnings among what the command wrote, as the report of a stage without times.
std::string report_of_warnings(std::string_view command, const std::string& messages) {
  std::istringstream lines(messages);
  const std::string start = fmt::format("{}: warning ", command);
  std::string warnings;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(": ", start.size());
    if (!line.starts_with(start) || colon == std::string::npos) continue;
    warnings +=
        fmt::format("{}{{\"code\": {}, \"message\": {}}}", warnings.empty() ? "" : ", ",
                    json_string(line.substr(start.size(), colon - start.size())), json_string(line.substr(colon + 2)));
  }
  return warnings.empty() ? std::string() : fmt::format("{{\"tool\": \"{}\", \"warnings\": [{}]}}", command, warnings);
}

/// Prints the messages of the command that are no warnings.
void print_notes(std::string_view command, const std::string& messages) {
  std::istringstream lines(messages);
  for (std::string line; std::getline(lines, line);)
    if (!line.starts_with(fmt::format("{}: warning ", command))) fmt::print(stderr, "{}\n", line);
}

/// Messages of the command about its options are about those of quadmesh.
std::string with_own_name(const std::string& command, std::string text) {
  for (const auto& [from, to] : {std::pair{command + ": ", "quadmesh: "}, {command + " --help", "quadmesh --help"}})
    for (std::size_t at = 0; (at = text.find(from, at)) != std::string::npos; at += std::string(to).size())
      text.replace(at, from.size(), to);
  return text;
}

/// A file with the shape, which may be standard input.
std::string shape_file(ChainState& chain) {
  if (chain.options.shape != "-" || !chain.standard_input) return chain.options.shape;
  std::string path = chain.runner.scratch() + "/points";
  io::write_output(path, *chain.standard_input, true, io::Lasting::for_the_run);
  return path;
}

/// Runs the command and passes its messages on.
void run_converter(ChainState& chain, const std::string& command, std::vector<std::string> words) {
  words.front() = command_path(command);
  const auto [code, messages] = chain.runner.run_helper(words);
  if (code != 0) {
    cli::print_message(with_own_name(command, messages));
    const std::string line = messages.substr(0, messages.find('\n'));
    const bool is_own = line.starts_with(command + ": ") || line.starts_with("quadmesh: ");
    throw ChainFailure{static_cast<ExitCode>(code), command, is_own ? line.substr(line.find(": ") + 2) : line};
  }
  if (std::string report = report_of_warnings(command, messages); !report.empty()) {
    chain.runner.reports().push_back({command, std::move(report)});
    print_warnings(chain, 0);
  }
  if (!chain.options.is_quiet) print_notes(command, messages);
}

}  // namespace

const std::vector<ShapeConverter>& shape_converters() {
  static const std::vector<ShapeConverter> converters{{"points2step",
                                                       "points",
                                                       {".dat", ".xy"},
                                                       {{"--farfield", true},
                                                        {"--wake", true},
                                                        {"--chord", true},
                                                        {"--simplify-outline", true},
                                                        {"--points-tolerance", true},
                                                        {"--points-format", true},
                                                        {"--points-unit", true},
                                                        {"--points-corner-angle", true},
                                                        {"--face-name", true},
                                                        {"--straight", false}}},
                                                      {"drawing2step",
                                                       "a drawing",
                                                       {".dxf", ".svg"},
                                                       {{"--drawing-tolerance", true},
                                                        {"--drawing-layers", true},
                                                        {"--drawing-unit", true},
                                                        {"--embed", true},
                                                        {"--regions", false}}}};
  return converters;
}

const ShapeConverter* converter_with_option(const std::string& flag) {
  for (const ShapeConverter& converter : shape_converters())
    if (converter.options.contains(flag)) return &converter;
  return nullptr;
}

const ShapeConverter* converter_of_shape(const ChainOptions& options) {
  const ShapeConverter* converter = converter_by_ending(options.shape);
  for (const ShapeConverter& other : shape_converters()) {
    const auto words = options.words.find(std::string(other.command));
    if (words == options.words.end()) continue;
    if (converter && converter != &other)
      throw UsageError(fmt::format("{} is an option for {} ({}), but the shape is {}: leave it out",
                                   words->second.front(), other.input, fmt::join(other.endings, ", "),
                                   converter->input));
    converter = &other;
  }
  return converter;
}

std::string cad_file(ChainState& chain) {
  const ShapeConverter* converter =
      chain.options.first == ChainStage::cad2tri ? converter_of_shape(chain.options) : nullptr;
  if (!converter) return chain.options.shape;
  const std::string command(converter->command);
  std::string made = chain.files.stem + ".outline.step";
  std::vector<std::string> words{command, shape_file(chain), "-o", made};
  if (const auto chosen = chain.options.words.find(command); chosen != chain.options.words.end())
    words.insert(words.end(), chosen->second.begin(), chosen->second.end());
  if (chain.options.is_dry_run)
    cli::print_to_stdout(shell_command(words) + '\n');
  else
    run_converter(chain, command, words);
  return made;
}

}  // namespace quadrille::chain
