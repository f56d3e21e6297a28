#include "trace/trace_options.hpp"

#include "base/error.hpp"

namespace quadrille::trace {

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance must be positive");
  if (step < 0 || merge_distance < 0 || merge_angle < 0) throw UsageError("lengths and angles must not be negative");
  if (!(max_length > 0)) throw UsageError("the bounds must be positive");
}

}  // namespace quadrille::trace
