#pragma once
// Options over CLI11: parsing, the rows of the help text and the JSON record for the provenance. Private to cli.

#include <memory>
#include <string>
#include <vector>

#include "base/options.hpp"
#include "cli/help_text.hpp"
#include "cli/run_files.hpp"

namespace quadrille::cli {

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
  /// Fills the declared variables; the words request no help and no list (request.hpp). Throws UsageError.
  void parse(int argc, char** argv);
  /// Those that are declared, after parsing.
  void add_files(RunFiles& files) const;
  const HelpPage& page() const;
  bool writes_to_stdout() const;
  /// The tool's own options without --output, for programs: a line "TOOL --OPTION value" or "TOOL --OPTION flag" each.
  std::string option_list() const;
  /// The recorded options after defaults, as a JSON object with sorted keys.
  std::string options_json() const;
  void one_of(const std::string& flag, const std::vector<std::string>& words, const std::function<std::string()>& get,
              const std::function<void(const std::string&)>& set, const std::string& help) override;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::cli
