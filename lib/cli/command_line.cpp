#include "cli/options.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cmath>
#include <map>

#include "base/error.hpp"

namespace quadrille::cli {

namespace {

std::string json_text(const std::string& text) {
  std::string out = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\')
      out += {'\\', c};
    else if (static_cast<unsigned char>(c) < 0x20)
      out += fmt::format("\\u{:04x}", static_cast<int>(c));
    else
      out += c;
  }
  return out + '"';
}

/// The whole of `text` as a number; a leading + is allowed.
template <typename T>
bool parse_number(const std::string& text, T& value) {
  const char* const begin = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* const end = text.c_str() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && begin != end;
}

template <typename T>
std::string interval(T low, T high) {
  if constexpr (std::is_floating_point_v<T>) {
    constexpr double boundless = 1e300;
    const bool open_above = high >= boundless;
    if (low <= -boundless) return open_above ? "any number" : fmt::format("at most {}", high);
    if (open_above) return fmt::format("at least {}", low);
  } else if (high == std::numeric_limits<T>::max()) {
    return fmt::format("at least {}", low);
  }
  return fmt::format("{} to {}", low, high);
}

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

struct Row {
  std::string left, right;
};

std::string table(const std::vector<Row>& rows) {
  constexpr std::size_t indent = 28;
  std::string out;
  for (const Row& row : rows) {
    out += "  " + row.left;
    if (row.left.size() + 4 > indent)
      out += '\n' + std::string(indent, ' ');
    else
      out += std::string(indent - 2 - row.left.size(), ' ');
    out += wrapped(row.right, indent, 100 - indent) + '\n';
  }
  return out;
}

}  // namespace

struct CommandLine::Impl {
  explicit Impl(const Tool& t) : tool(t), app(t.summary, t.name) {
    app.set_help_flag("-h,--help");
    app.set_version_flag("--version", "");
  }

  CLI::Option* add(const std::string& flag, const std::string& placeholder, CLI::callback_t set, std::string help) {
    rows.push_back({flag + ' ' + placeholder, std::move(help)});
    CLI::Option* const option = app.add_option(flag, std::move(set));
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }
  static std::string key(const std::string& flag) {
    return flag.substr(flag.rfind("--") == std::string::npos ? 0 : flag.rfind("--") + 2);
  }
  void record(const std::string& flag, std::function<std::string()> json) { recorded[key(flag)] = std::move(json); }

  const Tool& tool;
  CLI::App app;
  std::vector<Row> inputs, rows, common_rows;
  std::string synopsis;
  std::map<std::string, std::function<std::string()>> recorded;
  int verbose = 0;
  bool quiet = false;
  CommonOptions* common = nullptr;
};

CommandLine::CommandLine(const Tool& tool) : impl_(std::make_unique<Impl>(tool)) {}
CommandLine::~CommandLine() = default;

void CommandLine::input(const std::string& name, std::string& path, const std::string& help, bool required) {
  if (path.empty() && !required) path = "-";
  impl_->inputs.push_back({name, required ? help : help + " (default: -, standard input)"});
  impl_->synopsis += required ? ' ' + name : " [" + name + ']';
  impl_->app.add_option(name, path)->required(required);
}

void CommandLine::inputs(const std::string& name, std::vector<std::string>& paths, const std::string& help) {
  if (paths.empty()) paths = {"-"};
  impl_->inputs.push_back({name + "...", help + " (default: -, standard input)"});
  impl_->synopsis += " [" + name + "...]";
  impl_->app.add_option(name, paths);
}

void CommandLine::output(std::string& path, const std::string& help) {
  if (path.empty()) path = "-";
  impl_->rows.push_back({"-o, --output FILE", help + " (default: -, standard output)"});
  impl_->app.add_option("-o,--output", path)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void CommandLine::number(const std::string& flag, double& value, double low, double high, const std::string& unit,
                         const std::string& help) {
  const std::string range = interval(low, high);
  const auto set = [=, &value](const CLI::results_t& texts) {
    double given = 0;
    if (!parse_number(texts.back(), given))
      throw UsageError(fmt::format("{}: '{}' is not a number", flag, texts.back()));
    if (!(given >= low && given <= high))
      throw UsageError(fmt::format("{}: {} is outside its interval ({})", flag, texts.back(), range));
    value = given;
    return true;
  };
  impl_->add(flag, "X", set, fmt::format("{} (unit: {}; default: {}; interval: {})", help, unit, value, range));
  impl_->record(flag, [&value] { return std::isfinite(value) ? fmt::format("{:.17g}", value) : std::string("null"); });
}

void CommandLine::integer(const std::string& flag, int& value, int low, int high, const std::string& help) {
  const std::string range = interval(low, high);
  const auto set = [=, &value](const CLI::results_t& texts) {
    int given = 0;
    if (!parse_number(texts.back(), given))
      throw UsageError(fmt::format("{}: '{}' is not an integer", flag, texts.back()));
    if (given < low || given > high)
      throw UsageError(fmt::format("{}: {} is outside its interval ({})", flag, texts.back(), range));
    value = given;
    return true;
  };
  impl_->add(flag, "N", set, fmt::format("{} (unit: none; default: {}; interval: {})", help, value, range));
  impl_->record(flag, [&value] { return std::to_string(value); });
}

void CommandLine::choice(const std::string& flag, std::string& value, const std::vector<std::string>& values,
                         const std::string& help) {
  const std::string list = fmt::format("{}", fmt::join(values, "|"));
  const auto set = [=, &value](const CLI::results_t& texts) {
    if (std::find(values.begin(), values.end(), texts.back()) == values.end())
      throw UsageError(fmt::format("{}: '{}' is not one of {}", flag, texts.back(), list));
    value = texts.back();
    return true;
  };
  impl_->add(flag, list, set, fmt::format("{} (default: {})", help, value));
  impl_->record(flag, [&value] { return json_text(value); });
}

void CommandLine::text(const std::string& flag, std::string& value, const std::string& placeholder,
                       const std::string& help, bool recorded) {
  const auto set = [&value](const CLI::results_t& texts) {
    value = texts.back();
    return true;
  };
  impl_->add(flag, placeholder, set, value.empty() ? help : fmt::format("{} (default: {})", help, value));
  if (recorded) impl_->record(flag, [&value] { return json_text(value); });
}

void CommandLine::texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
                        const std::string& help) {
  const auto set = [&values](const CLI::results_t& texts) {
    values = texts;
    return true;
  };
  impl_->add(flag, placeholder, set, help + " (may be given several times)")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  impl_->record(flag, [&values] {
    std::vector<std::string> quoted;
    for (const std::string& value : values) quoted.push_back(json_text(value));
    return fmt::format("[{}]", fmt::join(quoted, ","));
  });
}

void CommandLine::flag(const std::string& flag, bool& value, const std::string& help) {
  impl_->rows.push_back({flag, help});
  impl_->app.add_flag(flag, value);
  impl_->record(flag, [&value] { return value ? "true" : "false"; });
}

void CommandLine::add_common(CommonOptions& common) {
  impl_->common = &common;
  std::vector<Row> own;
  own.swap(impl_->rows);
  text("--report", common.report, "FILE",
       "write counts, timings, residuals and warnings as JSON, also after a failure (-: standard output)", false);
  choice("--progress", common.progress, {"auto", "always", "never"},
         "show progress on standard error; auto: on a terminal, for work longer than a second");
  integer("--threads", common.threads, 1, 1024, "number of threads; results do not depend on it");
  impl_->recorded.erase("progress");
  impl_->recorded.erase("threads");
  impl_->app.add_flag("-v,--verbose", impl_->verbose);
  impl_->app.add_flag("-q,--quiet", impl_->quiet);
  impl_->rows.push_back({"-v, --verbose", "say what is done; twice: say more"});
  impl_->rows.push_back({"-q, --quiet", "print errors only, no warnings"});
  impl_->rows.push_back({"-h, --help", "print this help and exit"});
  impl_->rows.push_back({"--version", "print the version and exit"});
  impl_->common_rows.swap(impl_->rows);
  impl_->rows.swap(own);
}

Request CommandLine::parse(int argc, char** argv) {
  try {
    impl_->app.parse(argc, argv);
  } catch (const CLI::CallForHelp&) {
    return Request::show_help;
  } catch (const CLI::CallForVersion&) {
    return Request::show_version;
  } catch (const CLI::ExtrasError&) {
    const std::vector<std::string> extras = impl_->app.remaining();
    throw UsageError(fmt::format("unknown option or superfluous argument '{}'", extras.empty() ? "" : extras.front()));
  } catch (const CLI::ParseError& e) {
    std::string message = e.what();
    for (char& c : message) c = c == '\n' ? ' ' : c;
    throw UsageError(message);
  }
  impl_->common->verbosity = impl_->quiet ? -1 : std::min(impl_->verbose, 2);
  return Request::run;
}

std::string CommandLine::help_text() const {
  const Tool& tool = impl_->tool;
  std::string out = fmt::format("Usage: {} [OPTIONS]{}\n\n{} {}.\n", tool.name, impl_->synopsis, tool.name,
                                wrapped(tool.summary, 0, 80));
  if (!tool.description.empty()) out += '\n' + wrapped(tool.description, 0, 100) + '\n';
  if (!impl_->inputs.empty()) out += "\nINPUTS\n" + table(impl_->inputs);
  if (!impl_->rows.empty()) out += "\nOPTIONS\n" + table(impl_->rows);
  out += "\nOPTIONS OF EVERY COMMAND\n" + table(impl_->common_rows);
  out += "\nEXIT CODES\n" + table({{"0", "done"},
                                   {"1", "well-formed input that has no valid result; the message says why and where"},
                                   {"2", "mistake on the command line"},
                                   {"3", "anything wrong with an input file"},
                                   {"4", "the output could not be written"},
                                   {"70", "a defect of ours"},
                                   {"128 + n", "ended by signal n"}});
  out += "\nEXAMPLES\n";
  for (const std::string& example : tool.examples) out += "  " + example + '\n';
  return out;
}

std::string CommandLine::options_json() const {
  std::string out = "{";
  for (const auto& [key, json] : impl_->recorded) {
    if (out.size() > 1) out += ',';
    out += json_text(key) + ':' + json();
  }
  return out + '}';
}

}  // namespace quadrille::cli
