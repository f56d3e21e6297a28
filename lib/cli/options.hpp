#pragma once
// Options over CLI11: parsing, the help text and the JSON record for the provenance. Private to the folder cli.

#include <memory>
#include <string>

#include "cli/tool_main.hpp"

namespace quadrille::cli {

/// The options that every command has.
struct CommonOptions {
  int verbosity = 0;  ///< -1 quiet, 0, 1, 2
  std::string report;
  std::string progress = "auto";
  int threads = 1;
};

/// What the command line asks for.
enum class Request { run, show_help, show_version };

class CommandLine : public Options {
 public:
  explicit CommandLine(const Tool& tool);
  ~CommandLine() override;

  void input(const std::string& name, std::string& path, const std::string& help, bool required) override;
  void inputs(const std::string& name, std::vector<std::string>& paths, const std::string& help) override;
  void output(std::string& path, const std::string& help) override;
  void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
              const std::string& help) override;
  void integer(const std::string& flag, int& value, int low, int high, const std::string& help) override;
  void choice(const std::string& flag, std::string& value, const std::vector<std::string>& values,
              const std::string& help) override;
  void text(const std::string& flag, std::string& value, const std::string& placeholder, const std::string& help,
            bool recorded) override;
  void texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
             const std::string& help) override;
  void flag(const std::string& flag, bool& value, const std::string& help) override;

  /// Adds the options of every command; called after the tool has declared its own.
  void add_common(CommonOptions& common);
  /// Fills the declared variables. Throws UsageError.
  Request parse(int argc, char** argv);
  std::string help_text() const;
  /// The recorded options after defaults, as a JSON object with sorted keys.
  std::string options_json() const;

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace quadrille::cli
