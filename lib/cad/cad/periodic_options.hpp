#pragma once
// The option --periodic of cad2tri.

#include <optional>
#include <string>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::cad {

/// A translation, or a rotation about a point, in file coordinates: x -> R(angle) x + shift.
struct GivenMotion {
  double angle = 0;  ///< radians
  Vec2 shift;        ///< a length
};

/// Sides, named by their curves, that are to be periodic.
struct PeriodicRequest {
  std::string first, second;
  std::optional<GivenMotion> motion;  ///< from the first to the second; none: from the curves
  std::string where;                  ///< the option, for messages
};

/// "A=B", "A=B:translate=DX,DY" or "A=B:rotate=DEGREES[,CX,CY]", about (0, 0) without a centre. Throws UsageError, with
/// the option, for anything else.
std::vector<PeriodicRequest> periodic_options(const std::vector<std::string>& options);

}  // namespace quadrille::cad
