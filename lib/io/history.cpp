#include "io/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace quadrille::io {

namespace {

/// The option of a tool that names an input of this format; empty: the input is an argument.
std::string option_of(const std::string& tool, const std::string& format) {
  static const std::map<std::string, std::string> options{{"order-map", "--orders"},
                                                          {"boundary-names", "--boundary-names"},
                                                          {"block-names", "--block-names"},
                                                          {"size-field", "--size-field"}};
  if (format == "critical-points") return tool == "fieldsolve" ? "--nodes" : "";
  const auto found = options.find(format);
  return found == options.end() ? "" : found->second;
}

std::string ending_of_input(const std::string& format) {
  return format == "critical-points" ? ".crit.json" : format == "order-map" ? ".orders" : '.' + format;
}

bool is_phase(const ProvenanceStep& step) {
  return std::any_of(step.inputs.begin(), step.inputs.end(),
                     [](const InputDigest& input) { return input.format == "critical-points"; });
}

/// Of what a step writes, `before` the ending of what the step before wrote.
std::string ending_of_output(const ProvenanceStep& step, const std::string& before) {
  static const std::map<std::string, std::string> endings{{"cad2tri", ".tri.h5"},
                                                          {"critpoints", ".crit.json"},
                                                          {"separatrix", ".sep.json"},
                                                          {"blocksplit", ".blocks.h5"},
                                                          {"quadrefine", ".quad.h5"}};
  if (step.tool == "fieldsolve") return is_phase(step) ? ".phase.solve.h5" : ".solve.h5";
  if (step.tool == "padapt") return before == ".phase.solve.h5" ? ".phase.h5" : ".field.h5";
  const auto found = endings.find(step.tool);
  return found == endings.end() ? '.' + step.tool : found->second;
}

std::string shell_word(const std::string& word) {
  const bool is_plain = !word.empty() && word.find_first_not_of(
                                             "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                             "0123456789_-+=:,./") == std::string::npos;
  if (is_plain) return word;
  std::string out = "'";
  for (const char c : word) out += c == '\'' ? "'\\''" : std::string(1, c);
  return out + '\'';
}

std::string option_text(const std::string& name, const nlohmann::json& value) {
  if (value.is_null() || value == false || (value.is_string() && value.get_ref<const std::string&>().empty()))
    return "";
  if (value == true) return " --" + name;
  if (value.is_array()) {
    std::string out;
    for (const nlohmann::json& one : value) out += option_text(name, one);
    return out;
  }
  return fmt::format(" --{}={}", name, shell_word(value.is_string() ? value.get<std::string>() : value.dump()));
}

std::string options_text(const std::string& json) {
  std::string out;
  const nlohmann::json options = nlohmann::json::parse(json, nullptr, false);
  if (options.is_object())
    for (const auto& [name, value] : options.items()) out += option_text(name, value);
  return out;
}

}  // namespace

std::string history_stem(const std::string& path) {
  if (path == "-") return "x";
  const std::size_t begin = path.rfind('/') == std::string::npos ? 0 : path.rfind('/') + 1;
  return path.substr(begin, path.find('.', begin) - begin);
}

std::vector<std::string> History::lines_of(const Provenance& chain, const std::string& sha256,
                                           const std::string& stem) {
  std::vector<std::string> lines;
  std::string before;  // the ending of the file that the step before wrote
  for (const ProvenanceStep& step : chain) {
    std::string command = shell_word(step.tool) + options_text(step.options);
    for (std::size_t i = 0; i < step.inputs.size(); ++i) {
      const InputDigest& input = step.inputs[i];
      const bool is_of_chain = i == 0 && !before.empty();
      const auto [known, is_new] =
          names_.insert({input.sha256, stem + (is_of_chain ? before : ending_of_input(input.format))});
      if (is_new && !is_of_chain)
        lines.push_back(fmt::format("# {}: {}, SHA-256 {}", known->second, input.format, input.sha256));
      const std::string option = option_of(step.tool, input.format);
      command += (option.empty() ? " " : ' ' + option + ' ') + shell_word(known->second);
    }
    before = ending_of_output(step, before);
    command += " -o " + shell_word(stem + before);
    if (commands_.insert(command).second) lines.push_back(command);
  }
  names_.insert({sha256, stem + before});
  return lines;
}

}  // namespace quadrille::io
