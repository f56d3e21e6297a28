#pragma once
// Options of tracing and merging separatrices.

#include <array>

#include "base/enum_names.hpp"

namespace quadrille::trace {

enum class Integrator {
  runge_kutta,     ///< in reference space with error control (trace/advance.hpp)
  adams_bashforth  ///< the paper's integrator with a fixed step, for comparison (trace/adams_bashforth.hpp)
};

constexpr auto enum_names(Integrator) { return std::to_array({"rk", "ab4"}); }

struct TraceOptions {
  Integrator integrator = Integrator::runge_kutta;
  double tolerance = 1e-10;  ///< bound of a step's estimated error, in diameters
  /// File units: the greatest step of the Runge-Kutta integrator (0: diameter / 20), every step of the fixed-step one
  /// (0: diameter / 500).
  double step = 0;
  /// Degrees: head-on separatrices are merged if neither changes its direction by more. On all benchmark shapes 15
  /// removes most thin chords and does not reduce the least scaled Jacobian of the mesh.
  double merge_angle = 15;
  double merge_distance = 0;  ///< file units: also separatrices that pass within this distance are merged
  double max_length = 20;     ///< of one line, in diameters
  /// Of all lines that are traced to their ends, in diameters. Few lines of plates with many holes are longer than one
  /// diameter; spirals have many.
  double max_total_length = 500;
  /// Of one line, in the mean over all lines, at least 100. Plates with many holes need 150, racks of teeth 400; a line
  /// in a damaged field takes max_stream_steps and gets nowhere.
  int max_steps = 1000;
  void validate() const;  ///< throws UsageError
};

}  // namespace quadrille::trace
