#include "io/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

namespace quadrille::io {

namespace {

/// The option by which the tool reads its `position`-th input of this format; empty: the input is an argument.
std::string option_of(const std::string& tool, std::size_t position, const std::string& format) {
  static const std::map<std::string, std::string> options{{"order-map", "--orders"},
                                                          {"boundary-names", "--boundary-names"},
                                                          {"block-names", "--block-names"},
                                                          {"size-field", "--size-field"}};
  if (tool == "fieldsolve" && position > 0 && format == "field") return "--orders";
  if (format == "critical-points") return tool == "fieldsolve" ? "--nodes" : "";
  const auto found = options.find(format);
  return found == options.end() ? "" : found->second;
}

std::string ending_of_input(const std::string& format) {
  static const std::map<std::string, std::string> endings{
      {"critical-points", ".crit.json"}, {"order-map", ".orders.json"}, {"field", ".orders.h5"}};
  const auto found = endings.find(format);
  return found == endings.end() ? '.' + format : found->second;
}

bool is_phase(const ProvenanceStep& step) {
  return std::any_of(step.inputs.begin(), step.inputs.end(),
                     [](const InputDigest& input) { return input.format == "critical-points"; });
}

/// Of what a step writes; `before` is the name of what the step before wrote.
std::string ending_of_output(const ProvenanceStep& step, const std::string& before) {
  static const std::map<std::string, std::string> endings{{"cad2tri", ".tri.h5"},
                                                          {"critpoints", ".crit.json"},
                                                          {"separatrix", ".sep.json"},
                                                          {"blocksplit", ".blocks.h5"},
                                                          {"quadrefine", ".quad.h5"}};
  if (step.tool == "fieldsolve") return is_phase(step) ? ".phase.solve.h5" : ".solve.h5";
  if (step.tool == "padapt") return before.find(".phase.") != std::string::npos ? ".phase.h5" : ".field.h5";
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

std::vector<MadeFile> oldest_first(std::vector<MadeFile> files) {
  const auto is_made_from = [](const MadeFile& file, const MadeFile& other) {
    return std::any_of(file.chain.begin(), file.chain.end(), [&](const ProvenanceStep& step) {
      return std::any_of(step.inputs.begin(), step.inputs.end(),
                         [&](const InputDigest& input) { return input.sha256 == other.sha256; });
    });
  };
  std::vector<MadeFile> ordered;
  while (!files.empty()) {
    auto next = std::find_if(files.begin(), files.end(), [&](const MadeFile& file) {
      return std::none_of(files.begin(), files.end(), [&](const MadeFile& other) { return is_made_from(file, other); });
    });
    if (next == files.end()) next = files.begin();  // digests that somebody wrote by hand
    ordered.push_back(std::move(*next));
    files.erase(next);
  }
  return ordered;
}

std::string History::new_name(const std::string& stem, const std::string& ending) {
  std::string name = stem + ending;
  for (int k = 2; !used_.insert(name).second; ++k) name = fmt::format("{}.{}{}", stem, k, ending);
  return name;
}

std::vector<std::string> History::lines_of(const Provenance& chain, const std::string& sha256,
                                           const std::string& stem) {
  std::vector<std::string> lines;
  std::string before;  // the file that the step before wrote
  for (const ProvenanceStep& step : chain) {
    std::string command = shell_word(step.tool) + options_text(step.options);
    std::string identity = command;
    for (std::size_t i = 0; i < step.inputs.size(); ++i) {
      const InputDigest& input = step.inputs[i];
      if (i == 0 && !before.empty()) {
        names_.insert({input.sha256, before});
      } else if (!names_.contains(input.sha256)) {
        const std::string name = new_name(stem, ending_of_input(input.format));
        names_.insert({input.sha256, name});
        lines.push_back(fmt::format("# {}: {}, SHA-256 {}", name, input.format, input.sha256));
      }
      const std::string option = option_of(step.tool, i, input.format);
      command += (option.empty() ? " " : ' ' + option + ' ') + shell_word(names_[input.sha256]);
      identity += ' ' + input.sha256;
    }
    std::string& output = outputs_[identity];
    if (output.empty()) {
      output = new_name(stem, ending_of_output(step, before));
      lines.push_back(command + " -o " + shell_word(output));
    }
    before = output;
  }
  names_.insert({sha256, before});
  return lines;
}

}  // namespace quadrille::io
