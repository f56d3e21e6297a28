#include "cli/command_line.hpp"

#include <fmt/format.h>

#include <CLI/App.hpp>
#include <CLI/Config.hpp>
#include <CLI/Formatter.hpp>
#include <algorithm>
#include <map>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/name_text.hpp"
#include "base/options.hpp"

namespace quadrille::cli {

namespace {

/// The whole of `text` as a number, with kind `what` in the refusal; a leading + is allowed.
template <typename T>
T parsed_number(const std::string& flag, const std::string& text, const char* what) {
  const bool has_plus = text.size() > 1 && text[0] == '+' && text[1] != '-';
  if (const std::optional<T> number = number_of<T>(text.substr(has_plus ? 1 : 0))) return *number;
  throw UsageError(fmt::format("{}: '{}' is not {}", flag, text, what));
}

}  // namespace

double number_within(const std::string& flag, const std::string& text, double low, double high) {
  const auto given = parsed_number<double>(flag, text, "a number");
  require_in_interval(flag, given, text, low, high);
  return given;
}

int integer_within(const std::string& flag, const std::string& text, int low, int high) {
  const auto given = parsed_number<int>(flag, text, "an integer");
  require_in_interval(flag, given, text, low, high);
  return given;
}

int threads_of(const std::string& text) { return text == "auto" ? 0 : integer_within("--threads", text, 1, 1024); }

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

  /// A choice without a default is a flag; one of the other words than the first may follow it.
  void add_flag_or_word(const std::string& flag, const std::vector<std::string>& words,
                        const std::function<void(const std::string&)>& set, const std::string& help) {
    const std::string list = fmt::format("{}", fmt::join(words.begin() + 1, words.end(), "|"));
    page.options.push_back({fmt::format("{} [{}]", flag, list), help});
    note(flag, OptionKind::flag);
    optional_words[flag] = words;
    const auto set_known = [=](const std::string& word) {
      if (std::ranges::find(words, word) == words.end())
        throw UsageError(fmt::format("{}: '{}' is not one of {}", flag, word, list));
      set(word);
      return std::string();
    };
    app.add_flag(fmt::format("{}{{{}}}", flag, words.front()))->check(set_known);
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

  /// The words of the command line after the command; a word that may follow a flag joined to it by =.
  std::vector<std::string> joined_words(int argc, char** argv) const {
    std::vector<std::string> words;
    for (int i = 1; i < argc; ++i) {
      const auto flag = words.empty() ? optional_words.end() : optional_words.find(words.back());
      if (flag != optional_words.end() && std::ranges::find(flag->second, argv[i]) != flag->second.end())
        words.back() += std::string("=") + argv[i];
      else
        words.emplace_back(argv[i]);
    }
    return words;
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
  std::vector<std::function<void(RunFiles&)>> files;               ///< that are declared, after parsing
  std::vector<OptionName> options;                                 ///< without those of every command
  std::map<std::string, std::vector<std::string>> optional_words;  ///< by flag
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
  if (impl_->common == nullptr) impl_->record.one_of(flag, words, get, set, help);
  if (get().empty()) return impl_->add_flag_or_word(flag, words, set, help);
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
    std::vector<std::string> words = impl_->joined_words(argc, argv);
    std::ranges::reverse(words);  // as CLI11 takes them
    impl_->app.parse(std::move(words));
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
