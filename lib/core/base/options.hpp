#pragma once
// The options of a stage or command: each is declared once, with its variable, interval, unit and help text, beside the
// function that has it. cli/command_line reads them from a command line; here their intervals are checked, on a command
// line or in a struct that a program filled, and their values written as JSON.

#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "base/enum_names.hpp"

namespace quadrille {

/// Declares options. Variables contain their defaults on entry. Numbers outside [low, high] are usage errors; --help
/// states unit, default and interval. Every option declared here is recorded in the provenance unless `recorded` is
/// switched off for it (-o, -v, --threads, --report and the like are never recorded). Programs that forward options
/// list those of a tool with its --list-options, which --help does not show, and what follows each (OptionKind).
/// Implementations override what they need: what they leave out does nothing.
class Options {
 public:
  virtual ~Options() = default;
  virtual void input(const std::string& /*name*/, std::string& /*path*/, const std::string& /*help*/,
                     bool /*required*/ = false) {}
  /// All remaining positional arguments; without any, "-" (standard input) is read.
  virtual void inputs(const std::string& /*name*/, std::vector<std::string>& /*paths*/, const std::string& /*help*/) {}
  virtual void output(std::string& /*path*/, const std::string& /*help*/) {}  ///< -o, --output
  virtual void number(const std::string& /*flag*/, double& /*value*/, double /*low*/, double /*high*/,
                      const std::string& /*unit*/, const std::string& /*help*/) {}
  /// As `number`, without a default: the value stays empty where the option is not given.
  virtual void optional_number(const std::string& /*flag*/, std::optional<double>& /*value*/, double /*low*/,
                               double /*high*/, const std::string& /*unit*/, const std::string& /*help*/) {}
  virtual void integer(const std::string& /*flag*/, int& /*value*/, int /*low*/, int /*high*/,
                       const std::string& /*help*/) {}
  virtual void text(const std::string& /*flag*/, std::string& /*value*/, const std::string& /*placeholder*/,
                    const std::string& /*help*/, bool /*recorded*/ = true) {}
  /// As `text`: a file that is read. No output may overwrite it.
  virtual void input_file(const std::string& flag, std::string& path, const std::string& placeholder,
                          const std::string& help, bool recorded = true) {
    text(flag, path, placeholder, help, recorded);
  }
  /// As `text`, never recorded: a file that is written beside the output. It may not be a file that is read.
  virtual void output_file(const std::string& flag, std::string& path, const std::string& help) {
    text(flag, path, "FILE", help, false);
  }
  /// May be given several times; the values keep their order. `records_none`: without any, an empty list is recorded.
  virtual void texts(const std::string& /*flag*/, std::vector<std::string>& /*values*/,
                     const std::string& /*placeholder*/, const std::string& /*help*/, bool /*records_none*/ = true) {}
  virtual void flag(const std::string& /*flag*/, bool& /*value*/, const std::string& /*help*/) {}
  /// A choice between `words`: `get` returns the present one (none: a flag, as cli has it), `set` takes one.
  virtual void one_of(const std::string& /*flag*/, const std::vector<std::string>& /*words*/,
                      const std::function<std::string()>& /*get*/,
                      const std::function<void(const std::string&)>& /*set*/, const std::string& /*help*/) {}

  /// One of the names of an enum.
  template <NamedEnum Enum>
  void choice(const std::string& flag, Enum& value, const std::string& help) {
    one_of(
        flag, all_enum_names<Enum>(), [&value] { return enum_name(value); },
        [&value](const std::string& name) { value = *enum_value<Enum>(name); }, help);
  }
  /// One of several words.
  void choice(const std::string& flag, std::string& value, const std::vector<std::string>& words,
              const std::string& help) {
    one_of(
        flag, words, [&value] { return value; }, [&value](const std::string& word) { value = word; }, help);
  }
};

/// "1 to 20", "at least 0"; bounds of 1e300 and the greatest integer count as none.
std::string interval_text(double low, double high);
std::string interval_text(int low, int high);

/// Throws UsageError unless `value`, given as `text`, is in [low, high].
void require_in_interval(const std::string& flag, double value, const std::string& text, double low, double high);
void require_in_interval(const std::string& flag, int value, const std::string& text, int low, int high);

/// Throws UsageError for the first declared number that is outside its interval.
class IntervalCheck : public Options {
 public:
  void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
              const std::string& help) override;
  void optional_number(const std::string& flag, std::optional<double>& value, double low, double high,
                       const std::string& unit, const std::string& help) override;
  void integer(const std::string& flag, int& value, int low, int high, const std::string& help) override;
};

/// The same for the options of a struct for which declare(Options&, Struct&) is found by its namespace.
template <typename Struct>
void require_intervals(Struct options) {
  IntervalCheck check;
  declare(check, options);
}

/// Keeps how the value of each recorded option is written. The declared variables must outlive it.
class OptionRecord : public Options {
 public:
  void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
              const std::string& help) override;
  void optional_number(const std::string& flag, std::optional<double>& value, double low, double high,
                       const std::string& unit, const std::string& help) override;
  void integer(const std::string& flag, int& value, int low, int high, const std::string& help) override;
  void text(const std::string& flag, std::string& value, const std::string& placeholder, const std::string& help,
            bool recorded) override;
  void texts(const std::string& flag, std::vector<std::string>& values, const std::string& placeholder,
             const std::string& help, bool records_none) override;
  void flag(const std::string& flag, bool& value, const std::string& help) override;
  void one_of(const std::string& flag, const std::vector<std::string>& words, const std::function<std::string()>& get,
              const std::function<void(const std::string&)>& set, const std::string& help) override;

  /// An object with sorted keys, the option names without their dashes.
  std::string json() const;

 private:
  /// `value` returns JSON, or nothing for an option that is left out.
  void record(const std::string& flag, std::function<std::string()> value);

  std::map<std::string, std::function<std::string()>> values_;
};

/// The recorded options of a struct for which declare(Options&, Struct&) is found by its namespace.
template <typename Struct>
std::string recorded_options(Struct options) {
  OptionRecord record;
  declare(record, options);
  return record.json();
}

}  // namespace quadrille
