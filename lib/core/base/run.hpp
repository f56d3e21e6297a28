#pragma once
// What a stage function is given beside its input and options: where its figures, messages and times go, and how many
// threads it may use. This one keeps the report alone; cli/session prints messages and measures times too.

#include <string>

#include "base/report.hpp"

namespace quadrille {

class Run {
 public:
  Run() = default;
  /// `threads`: at least 1; results do not depend on it.
  explicit Run(int threads) : threads_(threads) {}
  virtual ~Run() = default;
  Run(const Run&) = delete;
  Run& operator=(const Run&) = delete;

  Report& report() { return report_; }
  virtual int threads() const { return threads_; }
  /// A sentence about the work for a person; level 0: always, 1 and 2: if more is asked for.
  virtual void info(const std::string& /*text*/, int /*level*/ = 1) const {}
  /// The work until end_phase or the next begin_phase is a phase of this name, whose times are reported.
  virtual void begin_phase(const std::string& /*name*/) {}
  virtual void end_phase() {}

 protected:
  Report report_;

 private:
  int threads_ = 1;
};

}  // namespace quadrille
