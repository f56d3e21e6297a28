#pragma once
// How separatrices are traced and merged.

#include <string>

namespace quadrille::trace {

struct TraceOptions {
  std::string integrator = "rk";  ///< "rk": advance(); "ab4": the paper's, advance_adams_bashforth(), for comparison
  double tolerance = 1e-10;       ///< of the integrator: bound of a step's estimated error, as a share of the diameter
  double step = 0;  ///< of the integrator in file units: the greatest, 0: diameter / 20; of ab4 each, 0: diameter / 500
  /// Degrees: head-on lines are merged where that turns neither by more. On all benchmark shapes 15 removes most thin
  /// strips of blocks and leaves the least scaled Jacobian of the mesh as good as without.
  double merge_angle = 15;
  double merge_distance = 0;  ///< file units: and where their fronts meet within it
  double max_length = 20;     ///< of one line, in diameters
  void validate() const;      ///< throws UsageError
};

}  // namespace quadrille::trace
