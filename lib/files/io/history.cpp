#include "io/history.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <nlohmann/json.hpp>

#include "io/step_origin.hpp"
#include "model/stage_formats.hpp"

namespace quadrille::io {

namespace {

/// The row of an input that the tool reads by an option; nullptr: the input is an argument.
const OptionalInput* option_of(const std::string& tool, const std::string& format) {
  const auto found = std::find_if(optional_inputs.begin(), optional_inputs.end(),
                                  [&](const OptionalInput& row) { return row.tool == tool && row.format == format; });
  return found == optional_inputs.end() ? nullptr : &*found;
}

/// Of an input that no command makes.
std::string ending_of_input(const std::string& tool, const std::string& format) {
  const OptionalInput* row = option_of(tool, format);
  if (row) return '.' + std::string(row->ending);
  const auto writer = std::find_if(stage_tools.begin(), stage_tools.end(),
                                   [&](const StageTool& stage) { return stage.writes == format; });
  return '.' + (writer == stage_tools.end() ? format : std::string(writer->ending));
}

bool is_phase(const ProvenanceStep& step) {
  return std::any_of(step.inputs.begin(), step.inputs.end(),
                     [](const InputDigest& input) { return input.format == "critical-points"; });
}

/// Of what a step writes; `before` is the name of what the step before wrote.
std::string ending_of_output(const ProvenanceStep& step, const std::string& before) {
  if (converts_shapes(step.tool)) return ".step";
  const StageTool* stage = find_stage_tool(step.tool);
  std::string ending = '.' + (stage ? std::string(stage->ending) : step.tool);
  if (step.tool == "fieldsolve" && is_phase(step)) return ".phase" + ending;
  if (step.tool == "padapt" && before.find(".phase.") != std::string::npos) return ".phase.h5";
  return ending;
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
        const std::string name = new_name(stem, ending_of_input(step.tool, input.format));
        names_.insert({input.sha256, name});
        lines.push_back(fmt::format("# {}: {}, SHA-256 {}", name, input.format, input.sha256));
      }
      const OptionalInput* row = i == 0 ? nullptr : option_of(step.tool, input.format);
      command += (row ? ' ' + std::string(row->option) + ' ' : " ") + shell_word(names_[input.sha256]);
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
