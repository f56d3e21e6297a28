#pragma once
// The machine-readable report of a run (--report): counts, timings, residuals, certificates, warnings. A flat list of
// dotted keys in the order of their first use; io/chain_report nests them and writes JSON. It also leads to the
// progress, since it is passed to all long work.

#include <concepts>
#include <map>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "base/progress.hpp"

namespace quadrille {

class Report {
 public:
  using Value = std::variant<long long, double, bool, std::string, std::vector<double>>;

  Report() = default;
  /// With `progress`, which must outlive the report, for the parts of the work that is reported.
  explicit Report(Progress* progress) : progress_(progress) {}
  Progress* progress() const { return progress_; }  ///< null: not shown

  /// Sets `key` ("solve.residual"); a later value replaces an earlier one. Non-finite numbers are written as null.
  void set(const std::string& key, Value value) {
    const auto [known, is_new] = positions_.try_emplace(key, entries_.size());
    if (is_new)
      entries_.emplace_back(key, std::move(value));
    else
      entries_[known->second].second = std::move(value);
  }
  template <std::integral Integer>
  void set(const std::string& key, Integer value) {
    set(key, Value(static_cast<long long>(value)));
  }
  void set(const std::string& key, bool value) { set(key, Value(value)); }
  void set(const std::string& key, double value) { set(key, Value(value)); }
  void set(const std::string& key, const char* value) { set(key, Value(std::string(value))); }

  /// Adds a warning: a stable code ("W-CAD-001") and a sentence. Tools also print it unless --quiet is set.
  void warn(const std::string& code, const std::string& message) { warnings_.push_back({code, message}); }

  struct Warning {
    std::string code, message;
  };
  const std::vector<std::pair<std::string, Value>>& entries() const { return entries_; }
  const std::vector<Warning>& warnings() const { return warnings_; }

 private:
  Progress* progress_ = nullptr;
  std::vector<std::pair<std::string, Value>> entries_;
  std::map<std::string, std::size_t> positions_;  ///< in `entries_`
  std::vector<Warning> warnings_;
};

}  // namespace quadrille
