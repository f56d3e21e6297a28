#pragma once
// Options over CLI11: parsing, the values of options from texts, the rows of the help text and the JSON record for the
// provenance. Private to cli but for the values.

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/options.hpp"
#include "cli/run_files.hpp"

namespace quadrille::cli {

/// `text` as a number in the interval of the option `flag`; a leading + is allowed. Throws UsageError.
double number_within(const std::string& flag, const std::string& text, double low, double high);
int integer_within(const std::string& flag, const std::string& text, int low, int high);

/// The value of --threads: 0 for "auto". Throws UsageError.
int threads_of(const std::string& text);

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

/// What follows an option: nothing, a value, a value where the option may be given several times, the name of a file
/// that is read.
/// A choice without a default (an empty text) is of kind flag: alone it means the first of its words, another one may
/// follow it. Without it `false` is recorded.
enum class OptionKind { flag, value, values, file };
constexpr auto enum_names(OptionKind) { return std::to_array({"flag", "value", "values", "file"}); }

struct OptionName {
  std::string flag;  ///< "--order"
  OptionKind kind = OptionKind::value;
};

/// The options that every command has.
struct CommonOptions {
  int verbosity = 0;  ///< -1 quiet, 0, 1, 2
  std::string report;
  std::string progress = "auto";
  int threads = 0;  ///< 0: auto
};

class CommandLine : public Options {
 public:
  /// `page` has name, summary, description and examples; the declarations add the rest.
  explicit CommandLine(HelpPage page);
  ~CommandLine() override;

  void input(const std::string& name, std::string& path, const std::string& help, bool required) override;
  void inputs(const std::string& name, std::vector<std::string>& paths, const std::string& help) override;
  void output(std::string& path, const std::string& help) override;
  void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
              const std::string& help) override;
  void optional_number(const std::string& flag, std::optional<double>& value, double low, double high,
                       const std::string& unit, const std::string& help) override;
  void integer(const std::string& flag, int& value, int low, int high, const std::string& help) override;
  void text(const std::string& flag, std::string& value, const std::string& placeholder, const std::string& help,
            bool recorded) override;
  void input_file(const std::string& flag, std::string& path, const std::string& placeholder, const std::string& help,
                  bool recorded) override;
  void output_file(const std::string& flag, std::string& path, const std::string& help) override;
  void texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
             const std::string& help, bool records_none) override;
  void flag(const std::string& flag, bool& value, const std::string& help) override;

  /// Adds the options of every command; called after the tool has declared its own.
  void add_common(CommonOptions& common);
  /// Fills the declared variables; the words request no help and no list (outcome.hpp). Throws UsageError.
  void parse(int argc, char** argv);
  /// Those that are declared, after parsing.
  void add_files(RunFiles& files) const;
  const HelpPage& page() const;
  bool writes_to_stdout() const;
  /// The tool's own options without --output, in the order of their declaration.
  const std::vector<OptionName>& option_names() const;
  /// The same for programs: a line "TOOL --OPTION KIND" each.
  std::string option_list() const;
  /// The recorded options after defaults, as a JSON object with sorted keys.
  std::string options_json() const;
  /// Where `help` has a line "word: meaning" for each word after its first one, the words stand there alone.
  void one_of(const std::string& flag, const std::vector<std::string>& words, const std::function<std::string()>& get,
              const std::function<void(const std::string&)>& set, const std::string& help) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::cli
