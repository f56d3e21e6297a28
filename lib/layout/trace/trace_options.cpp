#include "trace/trace_options.hpp"

#include "base/error.hpp"

namespace quadrille::trace {

void TraceOptions::validate() const {
  if (!(tolerance > 0)) throw UsageError("the tolerance of the integrator must be positive");
  if (step < 0 || merge_distance < 0 || merge_angle < 0)
    throw UsageError("step, merge distance and merge angle must not be negative");
  if (!(max_total_length > 0)) throw UsageError("the greatest total length of the lines must be positive");
  if (max_steps < 1) throw UsageError("the greatest number of steps of a line must be positive");
  if (!(max_length > 0)) throw UsageError("the greatest length of a line must be positive");
}

}  // namespace quadrille::trace
