#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "base/name_text.hpp"
#include "base/options.hpp"

namespace quadrille::cli {

namespace {

/// The whole of `text` as a number; a leading + is allowed.
template <typename T>
bool parse_number(const std::string& text, T& value) {
  const char* const begin = text.c_str() + (text.size() > 1 && text[0] == '+' && text[1] != '-' ? 1 : 0);
  const char* const end = text.c_str() + text.size();
  const auto [stop, error] = std::from_chars(begin, end, value);
  return error == std::errc() && stop == end && begin != end;
}

}  // namespace

double number_within(const std::string& flag, const std::string& text, double low, double high) {
  double given = 0;
  if (!parse_number(text, given)) throw UsageError(fmt::format("{}: '{}' is not a number", flag, text));
  require_in_interval(flag, given, text, low, high);
  return given;
}

int integer_within(const std::string& flag, const std::string& text, int low, int high) {
  int given = 0;
  if (!parse_number(text, given)) throw UsageError(fmt::format("{}: '{}' is not an integer", flag, text));
  require_in_interval(flag, given, text, low, high);
  return given;
}

int threads_of(const std::string& text) { return text == "auto" ? 0 : integer_within("--threads", text, 1, 1024); }

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

struct CommandLine::Impl {
  explicit Impl(HelpPage help) : page(std::move(help)), app(page.summary, page.name) {
    app.set_help_flag("-h,--help");
    app.set_version_flag("--version", "");
  }

  CLI::Option* add(const std::string& flag, const std::string& placeholder, CLI::callback_t set, std::string help) {
    page.options.push_back({flag + ' ' + placeholder, std::move(help)});
    note(flag, OptionKind::value);
    CLI::Option* const option = app.add_option(flag, std::move(set));
    return option->expected(1)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
  }

  /// Keeps the name of an option of the tool itself.
  void note(const std::string& flag, OptionKind kind) {
    if (common == nullptr) options.push_back({flag, kind});
  }

  void add_threads(int& threads) {
    const auto set = [&threads](const CLI::results_t& texts) {
      threads = threads_of(texts.back());
      return true;
    };
    add("--threads", "N|auto", set,
        "number of threads, 1 to 1024; auto: as many as there are processors, for work that lasts longer than 0.2 s; "
        "results do not depend on it (default: auto)");
  }

  /// Names the first word that is no option, with the nearest one, or the first surplus argument. Throws UsageError.
  void require_no_extras() const {
    const std::vector<std::string> extras = app.remaining();
    if (extras.empty()) return;
    const auto is_option = [](const std::string& word) { return word.size() > 1 && word[0] == '-'; };
    const auto unknown = std::find_if(extras.begin(), extras.end(), is_option);
    if (unknown == extras.end()) throw UsageError(fmt::format("surplus argument '{}'", extras.front()));
    const std::string name = unknown->substr(0, unknown->find('='));
    const std::string nearest = nearest_word(name, visible_options());
    throw UsageError(fmt::format("unknown option {}{}", name,
                                 nearest.empty() ? std::string() : fmt::format(": did you mean {}?", nearest)));
  }
  std::vector<std::string> visible_options() const {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    return names;
  }

  HelpPage page;
  CLI::App app;
  OptionRecord record;
  int verbose = 0;
  bool quiet = false;
  CommonOptions* common = nullptr;
  const std::string* output = nullptr;
  std::vector<std::function<void(RunFiles&)>> files;  ///< that are declared, after parsing
  std::vector<OptionName> options;                    ///< without those of every command
};

CommandLine::CommandLine(HelpPage page) : impl_(std::make_unique<Impl>(std::move(page))) {}
CommandLine::~CommandLine() = default;

void CommandLine::input(const std::string& name, std::string& path, const std::string& help, bool required) {
  if (path.empty() && !required) path = "-";
  impl_->page.inputs.push_back({name, required ? help : help + " (default: -, standard input)"});
  impl_->page.synopsis += required ? ' ' + name : " [" + name + ']';
  impl_->files.emplace_back([&path](RunFiles& files) { files.read(path); });
  impl_->app.add_option(name, path)->required(required);
}

void CommandLine::inputs(const std::string& name, std::vector<std::string>& paths, const std::string& help) {
  if (paths.empty()) paths = {"-"};
  impl_->page.inputs.push_back({name + "...", help + " (default: -, standard input)"});
  impl_->page.synopsis += " [" + name + "...]";
  impl_->files.emplace_back([&paths](RunFiles& files) {
    for (const std::string& path : paths) files.read(path);
  });
  impl_->app.add_option(name, paths);
}

void CommandLine::output(std::string& path, const std::string& help) {
  if (path.empty()) path = "-";
  impl_->page.options.push_back({"-o, --output FILE", help + " (default: -, standard output)"});
  impl_->output = &path;
  impl_->files.emplace_back([&path](RunFiles& files) { files.write(path, "--output"); });
  impl_->app.add_option("-o,--output", path)->multi_option_policy(CLI::MultiOptionPolicy::TakeLast);
}

void CommandLine::number(const std::string& flag, double& value, double low, double high, const std::string& unit,
                         const std::string& help) {
  const std::string range = interval_text(low, high);
  const auto set = [=, &value](const CLI::results_t& texts) {
    value = number_within(flag, texts.back(), low, high);
    return true;
  };
  impl_->add(flag, "X", set, fmt::format("{} (unit: {}; default: {}; interval: {})", help, unit, value, range));
  impl_->record.number(flag, value, low, high, unit, help);
}

void CommandLine::optional_number(const std::string& flag, std::optional<double>& value, double low, double high,
                                  const std::string& unit, const std::string& help) {
  const auto set = [=, &value](const CLI::results_t& texts) {
    value = number_within(flag, texts.back(), low, high);
    return true;
  };
  impl_->add(flag, "X", set,
             fmt::format("{} (unit: {}; default: none; interval: {})", help, unit, interval_text(low, high)));
  impl_->record.optional_number(flag, value, low, high, unit, help);
}

void CommandLine::integer(const std::string& flag, int& value, int low, int high, const std::string& help) {
  const std::string range = interval_text(low, high);
  const auto set = [=, &value](const CLI::results_t& texts) {
    value = integer_within(flag, texts.back(), low, high);
    return true;
  };
  impl_->add(flag, "N", set, fmt::format("{} (unit: none; default: {}; interval: {})", help, value, range));
  impl_->record.integer(flag, value, low, high, help);
}

void CommandLine::one_of(const std::string& flag, const std::vector<std::string>& words,
                         const std::function<std::string()>& get, const std::function<void(const std::string&)>& set,
                         const std::string& help) {
  const std::string list = fmt::format("{}", fmt::join(words, "|"));
  const auto set_known = [=](const CLI::results_t& texts) {
    if (std::find(words.begin(), words.end(), texts.back()) == words.end())
      throw UsageError(fmt::format("{}: '{}' is not one of {}", flag, texts.back(), list));
    set(texts.back());
    return true;
  };
  const std::size_t line = std::min(help.find('\n'), help.size());
  impl_->add(flag, line < help.size() ? "WORD" : list, set_known,
             fmt::format("{} (default: {}){}", help.substr(0, line), get(), help.substr(line)));
  if (impl_->common == nullptr) impl_->record.one_of(flag, words, get, set, help);
}

void CommandLine::text(const std::string& flag, std::string& value, const std::string& placeholder,
                       const std::string& help, bool recorded) {
  const auto set = [&value](const CLI::results_t& texts) {
    value = texts.back();
    return true;
  };
  impl_->add(flag, placeholder, set, value.empty() ? help : fmt::format("{} (default: {})", help, value));
  impl_->record.text(flag, value, placeholder, help, recorded);
}

void CommandLine::input_file(const std::string& flag, std::string& path, const std::string& placeholder,
                             const std::string& help, bool recorded) {
  Options::input_file(flag, path, placeholder, help, recorded);
  impl_->options.back().kind = OptionKind::file;
  impl_->files.emplace_back([&path](RunFiles& files) { files.read(path); });
}

void CommandLine::output_file(const std::string& flag, std::string& path, const std::string& help) {
  Options::output_file(flag, path, help);
  impl_->files.emplace_back([&path, flag](RunFiles& files) { files.write(path, flag); });
}

void CommandLine::texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
                        const std::string& help, bool records_none) {
  const auto set = [&values](const CLI::results_t& texts) {
    values = texts;
    return true;
  };
  impl_->add(flag, placeholder, set, help + " (may be given several times)")
      ->multi_option_policy(CLI::MultiOptionPolicy::TakeAll);
  impl_->options.back().kind = OptionKind::values;
  impl_->record.texts(flag, values, placeholder, help, records_none);
}

void CommandLine::flag(const std::string& flag, bool& value, const std::string& help) {
  impl_->page.options.push_back({flag, help});
  impl_->note(flag, OptionKind::flag);
  impl_->app.add_flag(flag, value);
  impl_->record.flag(flag, value, help);
}

void CommandLine::add_common(CommonOptions& common) {
  impl_->common = &common;
  std::vector<HelpRow> own;
  own.swap(impl_->page.options);
  output_file("--report", common.report,
              "write counts, timings, residuals and warnings as JSON, also after a failure (-: standard output)");
  choice("--progress", common.progress, {"auto", "always", "never"},
         "show progress on standard error; auto: on a terminal, for work longer than a second");
  impl_->add_threads(common.threads);
  impl_->app.add_flag("-v,--verbose", impl_->verbose);
  impl_->app.add_flag("-q,--quiet", impl_->quiet);
  const std::vector<HelpRow> flags{{"-v, --verbose", "report what is done; given twice: also the time of each phase"},
                                   {"-q, --quiet", "print errors only, no warnings"},
                                   {"-h, --help", "print this help and exit"},
                                   {"--version", "print the version and exit"}};
  impl_->page.options.insert(impl_->page.options.end(), flags.begin(), flags.end());
  impl_->page.common_options.swap(impl_->page.options);
  impl_->page.options.swap(own);
}

void CommandLine::parse(int argc, char** argv) {
  try {
    impl_->app.parse(argc, argv);
  } catch (const CLI::ArgumentMismatch& e) {
    const std::string message = e.what();
    throw UsageError(message.substr(0, message.find(':')) + " needs a value");
  } catch (const CLI::ParseError& e) {
    impl_->require_no_extras();
    std::string message = e.what();
    for (char& c : message) c = c == '\n' ? ' ' : c;
    throw UsageError(message);
  }
  if (impl_->common != nullptr) impl_->common->verbosity = impl_->quiet ? -1 : std::min(impl_->verbose, 2);
}

void CommandLine::add_files(RunFiles& files) const {
  for (const auto& add : impl_->files) add(files);
}

const HelpPage& CommandLine::page() const { return impl_->page; }

bool CommandLine::writes_to_stdout() const { return impl_->output != nullptr && *impl_->output == "-"; }

const std::vector<OptionName>& CommandLine::option_names() const { return impl_->options; }

std::string CommandLine::option_list() const {
  std::string lines;
  for (const OptionName& option : impl_->options)
    lines += fmt::format("{} {} {}\n", impl_->page.name, option.flag, enum_name(option.kind));
  return lines;
}

std::string CommandLine::options_json() const { return impl_->record.json(); }

}  // namespace quadrille::cli
