// The command line of quadmesh. Options of stages are kept as words for them.

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <filesystem>
#include <set>
#include <system_error>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "chain/chain_options.hpp"
#include "chain/shape_converters.hpp"
#include "cli/command_line.hpp"
#include "cli/stage_words.hpp"
#include "triangulate/size_triangles.hpp"

namespace quadrille::chain {

namespace {

const std::vector<std::string> own_flags{"--help",    "--help-all", "--verbose",     "--quiet",
                                         "--version", "--dry-run",  "--keep-joints", "--sweep"};
const std::vector<std::string> own_values{"--output", "--workdir",     "--html",       "--html-parts",
                                          "--report", "--max-seconds", "--max-memory", "--threads",
                                          "--nodes",  "--from",        "--until",      "--stage"};
const std::set<std::string> of_cad2tri{"--face",     "--boundary-names", "--name",           "--region-name",
                                       "--periodic", "--offset",         "--heal-tolerance", "--fit-tolerance",
                                       "--blunt",    "--write-healed",   "--keep-joints",    "--section"};
/// The stages whose options are options of quadmesh.
constexpr std::array open_stages{ChainStage::critpoints, ChainStage::separatrix, ChainStage::blocksplit,
                                 ChainStage::quadrefine, ChainStage::hexsweep,   ChainStage::quadexport};

bool contains(const std::vector<std::string>& words, const std::string& word) {
  return std::find(words.begin(), words.end(), word) != words.end();
}

bool is_flag(const std::string& flag) {
  const ShapeConverter* converter = converter_with_option(flag);
  return contains(own_flags, flag) || (converter && !converter->options.at(flag));
}

bool has_value(const std::string& flag) {
  return !is_flag(flag) && (of_cad2tri.contains(flag) || converter_with_option(flag) || contains(own_values, flag));
}

/// An option of stages, and the stages that have it.
struct SharedOption {
  std::vector<std::string> tools;
  cli::OptionKind kind = cli::OptionKind::value;
};

std::map<std::string, SharedOption> shared_options() {
  std::map<std::string, SharedOption> all;
  StageOptions values;
  for (const ChainStage stage : open_stages)
    for (const cli::OptionName& name : cli::option_names([&](Options& o) { declare(o, stage, values); }))
      all[name.flag].tools.push_back(enum_name(stage)), all[name.flag].kind = name.kind;
  all["--symmetry"].tools.push_back("cad2tri");
  for (const char* flag : {"--align", "--align-strength"}) all[flag].tools.push_back("fieldsolve");
  return all;
}

class Reader {
 public:
  Reader(const std::vector<std::string>& arguments, ChainOptions& options)
      : words_(arguments.begin(), arguments.end()), options_(options) {}

  void read() {
    while (!words_.empty()) {
      const std::string word = words_.front();
      if (word.starts_with("--") && word.find('=') != std::string::npos)
        split_at_equals(word);
      else if (word.size() > 2 && word[0] == '-' && word[1] != '-')
        split_letters(word);
      else if (word.size() > 1 && word[0] == '-')
        take_option(word);
      else
        take_shape(word);
    }
  }

 private:
  /// --option=value becomes --option value.
  void split_at_equals(const std::string& word) {
    const std::size_t end = word.find('=');
    const std::string flag = word.substr(0, end);
    if (takes_no_value(flag)) throw UsageError(flag + " takes no value");
    words_.front() = word.substr(end + 1);
    words_.insert(words_.begin(), flag);
    take_option(flag);
  }

  /// -qv becomes -q -v, -oFILE becomes -o FILE.
  void split_letters(const std::string& word) {
    const std::string flag = word.substr(0, 2), rest = word.substr(2);
    if (flag != "-o" && flag != "-v" && flag != "-q" && flag != "-h") unknown(flag);
    words_.front() = flag == "-o" ? rest : '-' + rest;
    words_.insert(words_.begin(), flag);
    if (flag == "-o") take_option(flag);
  }

  bool takes_no_value(const std::string& flag) {
    if (is_flag(flag)) return true;
    if (has_value(flag)) return false;
    const auto found = shared().find(flag);
    return found != shared().end() && found->second.kind == cli::OptionKind::flag;
  }

  const std::map<std::string, SharedOption>& shared() {
    if (shared_.empty()) shared_ = shared_options();
    return shared_;
  }

  void take_option(const std::string& word) {
    static const std::map<std::string, std::string> long_names{
        {"-o", "--output"}, {"-v", "--verbose"}, {"-q", "--quiet"}, {"-h", "--help"}};
    const auto found = long_names.find(word);
    const std::string flag = found == long_names.end() ? word : found->second;
    words_.erase(words_.begin());
    if (is_flag(flag)) return take_flag(flag);
    if (has_value(flag)) return take_value(flag, value_of(word));
    const auto option = shared().find(flag);
    if (option == shared().end()) unknown(word);
    if (option->second.kind == cli::OptionKind::flag) return choose(option->second.tools, {flag});
    choose(option->second.tools, {flag, value_of(word)});
  }

  /// The next word; it may be empty or begin with one -, but must not be an option.
  std::string value_of(const std::string& word) {
    if (words_.empty()) throw UsageError(word + " needs a value");
    std::string value = words_.front();
    if (value.size() > 2 && value.starts_with("--"))
      throw UsageError(fmt::format("{} needs a value, not the option {}", word, value));
    words_.erase(words_.begin());
    return value;
  }

  void take_flag(const std::string& flag) {
    if (of_cad2tri.contains(flag)) options_.cad_option = flag, choose({"cad2tri"}, {flag});
    if (flag == "--verbose") options_.is_verbose = true;
    if (flag == "--quiet") options_.is_quiet = true;
    if (flag == "--dry-run") options_.is_dry_run = true;
    if (flag == "--sweep") options_.is_swept = true;
    if (const ShapeConverter* converter = converter_with_option(flag)) choose_for(*converter, {flag});
  }

  void choose_for(const ShapeConverter& converter, const std::vector<std::string>& words) {
    options_.converter_option = words.front();
    choose({std::string(converter.command)}, words);
  }

  void take_value(const std::string& flag, const std::string& value) {
    if (of_cad2tri.contains(flag)) {
      options_.cad_option = flag;
      if (!value.empty() || flag == "--name" || flag == "--region-name" || flag == "--periodic" || flag == "--offset")
        choose({"cad2tri"}, {flag, value});
    } else if (const ShapeConverter* converter = converter_with_option(flag)) {
      choose_for(*converter, {flag, value});
    } else if (flag == "--nodes") {
      take_nodes(value);
    } else if (flag == "--stage") {
      take_program(value);
    } else {
      take_own_value(flag, value);
    }
  }

  void take_own_value(const std::string& flag, const std::string& value) {
    if (flag == "--output") options_.output = value;
    if (flag == "--workdir") options_.workdir = value;
    if (flag == "--html") options_.html = value;
    if (flag == "--html-parts") options_.page_parts = page_parts(value);
    if (flag == "--report") options_.report = value;
    if (flag == "--threads") options_.threads = value, options_.num_threads = cli::threads_of(value);
    if (flag == "--max-seconds") options_.limits.seconds = parse_max_seconds(value);
    if (flag == "--max-memory") options_.limits.memory = parse_max_memory(value);
    if (flag == "--from") options_.first = stage_named(flag, value), options_.from = value;
    if (flag == "--until") options_.last = stage_named(flag, value), options_.until = value;
  }

  void take_nodes(const std::string& value) {
    if (value == "auto" || value == "none" || value == "fewest" || value == "field")
      choose({"critpoints"}, {"--nodes", value});
    else
      options_.nodes_file = value;
  }

  void take_program(const std::string& value) {
    const std::size_t end = value.find('=');
    if (end == std::string::npos || end + 1 == value.size())
      throw UsageError(fmt::format("--stage: '{}' is not NAME=COMMAND", value));
    options_.programs[stage_named("--stage", value.substr(0, end))] = value.substr(end + 1);
  }

  static std::vector<PagePart> page_parts(const std::string& value) {
    std::vector<PagePart> parts;
    const std::vector<std::string> names = all_enum_names<PagePart>();
    for (const std::string& name : split_at_commas(value)) {
      const auto part = enum_value<PagePart>(name);
      if (!part)
        throw UsageError(fmt::format("--html-parts: '{}' is no part of a page{}: the parts are {}", name,
                                     did_you_mean(name, names), fmt::join(names, " ")));
      parts.push_back(*part);
    }
    return parts;
  }

  static ChainStage stage_named(const std::string& flag, const std::string& name) {
    if (const auto stage = enum_value<ChainStage>(name)) return *stage;
    const std::vector<std::string> names = all_enum_names<ChainStage>();
    throw UsageError(fmt::format("{}: '{}' is no stage{}: the stages are {}", flag, name, did_you_mean(name, names),
                                 fmt::join(names, " ")));
  }

  void choose(const std::vector<std::string>& tools, const std::vector<std::string>& words) {
    for (const std::string& tool : tools) {
      std::vector<std::string>& chosen = options_.words[tool];
      chosen.insert(chosen.end(), words.begin(), words.end());
    }
  }

  [[noreturn]] void unknown(const std::string& word) {
    std::vector<std::string> known = own_values;
    known.insert(known.end(), of_cad2tri.begin(), of_cad2tri.end());
    for (const ShapeConverter& converter : shape_converters())
      for (const auto& [flag, has_value] : converter.options) known.push_back(flag);
    known.insert(known.end(), own_flags.begin(), own_flags.end());
    for (const auto& [flag, option] : shared()) known.push_back(flag);
    const std::string nearest = nearest_word(word, known);
    throw UsageError(
        fmt::format("unknown option {}{}", word, nearest.empty() ? "" : fmt::format(": did you mean {}?", nearest)));
  }

  void take_shape(const std::string& word) {
    if (!options_.shape.empty()) throw UsageError(fmt::format("more than one shape: {} and {}", options_.shape, word));
    if (word.empty()) throw UsageError("the name of the shape is empty");
    options_.shape = word;
    words_.erase(words_.begin());
  }

  std::vector<std::string> words_;  ///< that are left
  ChainOptions& options_;
  std::map<std::string, SharedOption> shared_;  ///< of the stages, once they are needed
};

/// The command for a shell; files without folders, so that the page can be given away.
std::string typed_command(const std::vector<std::string>& arguments) {
  std::vector<std::string> words{"quadmesh"};
  std::error_code ignored;
  for (const std::string& word : arguments) {
    const std::size_t slash = word.rfind('/');
    const std::size_t begin = word.starts_with("--") && word.find('=') != std::string::npos ? word.find('=') + 1 : 0;
    const bool is_path = slash != std::string::npos && slash >= begin &&
                         std::filesystem::is_directory(word.substr(begin, slash - begin), ignored);
    words.push_back(is_path ? word.substr(0, begin) + word.substr(slash + 1) : word);
  }
  return shell_command(words);
}

}  // namespace

void declare(Options& options, ChainStage stage, StageOptions& values) {
  switch (stage) {
    case ChainStage::cad2tri:
      return declare(options, values.cad2tri);
    case ChainStage::fieldsolve:
      return declare(options, values.fieldsolve);
    case ChainStage::padapt:
      return declare(options, values.padapt);
    case ChainStage::critpoints:
      return declare(options, values.critpoints);
    case ChainStage::separatrix:
      return declare(options, values.separatrix);
    case ChainStage::blocksplit:
      return declare(options, values.blocksplit);
    case ChainStage::quadrefine:
      values.quadrefine.join_points = triangulate::add_size_triangles;
      return declare(options, values.quadrefine);
    case ChainStage::hexsweep:
      return declare(options, values.hexsweep);
    case ChainStage::quadexport:
      return declare(options, values.quadexport);
  }
}

bool ChainOptions::has(const std::string& tool, const std::string& flag) const {
  const auto found = words.find(tool);
  return found != words.end() && contains(found->second, flag);
}

void read_command_line(const std::vector<std::string>& arguments, ChainOptions& options) {
  options.typed = typed_command(arguments);
  Reader(arguments, options).read();
}

std::string option_list() {
  using cli::OptionKind;
  std::map<std::string, OptionKind> kinds;
  for (const auto& [flag, option] : shared_options()) kinds[flag] = option.kind;
  for (const std::string& flag : own_values) kinds[flag] = OptionKind::value;
  for (const ShapeConverter& converter : shape_converters())
    for (const auto& [flag, has_value] : converter.options)
      kinds[flag] = has_value ? OptionKind::value : OptionKind::flag;
  StageOptions values;
  for (const cli::OptionName& name : cli::option_names([&](Options& o) { declare(o, ChainStage::cad2tri, values); }))
    if (of_cad2tri.contains(name.flag)) kinds[name.flag] = name.kind;
  for (const std::string& flag : own_flags) kinds[flag] = OptionKind::flag;
  kinds["--stage"] = OptionKind::values;
  for (const char* flag : {"--help", "--help-all", "--version", "--output"}) kinds.erase(flag);
  std::string lines;
  for (const auto& [flag, kind] : kinds) lines += fmt::format("quadmesh {} {}\n", flag, enum_name(kind));
  return lines;
}

StageOptions stage_options(const ChainOptions& options) {
  StageOptions values;
  for (int i = 0; i < num_stages; ++i) {
    const auto stage = static_cast<ChainStage>(i);
    const auto words = options.words.find(enum_name(stage));
    if (words != options.words.end()) cli::set_options([&](Options& o) { declare(o, stage, values); }, words->second);
  }
  return values;
}

std::string shell_command(const std::vector<std::string>& words) {
  std::string line;
  for (const std::string& word : words) {
    const bool is_plain = !word.empty() && word.find_first_not_of(
                                               "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ"
                                               "0123456789_./:=,+%@-") == std::string::npos;
    line += line.empty() ? "" : " ";
    if (is_plain) {
      line += word;
      continue;
    }
    line += '\'';
    for (const char c : word) line += c == '\'' ? std::string("'\\''") : std::string(1, c);
    line += '\'';
  }
  return line;
}

}  // namespace quadrille::chain
