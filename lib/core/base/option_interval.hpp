#pragma once
// The intervals of numeric options: as text, and checked, on a command line or in a struct that a program filled.

#include <string>

#include "base/options.hpp"

namespace quadrille {

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
  void integer(const std::string& flag, int& value, int low, int high, const std::string& help) override;
};

/// The same for the options of a struct for which declare(Options&, Struct&) is found by its namespace.
template <typename Struct>
void require_intervals(Struct options) {
  IntervalCheck check;
  declare(check, options);
}

}  // namespace quadrille
