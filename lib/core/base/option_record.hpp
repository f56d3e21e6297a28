#pragma once
// The values of declared options as JSON, for the provenance of what they led to.

#include <functional>
#include <map>
#include <string>
#include <vector>

#include "base/options.hpp"

namespace quadrille {

/// Keeps how the value of each recorded option is written. The declared variables must outlive it.
class OptionRecord : public Options {
 public:
  void number(const std::string& flag, double& value, double low, double high, const std::string& unit,
              const std::string& help) override;
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
