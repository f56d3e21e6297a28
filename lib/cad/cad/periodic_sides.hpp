#pragma once
// Periodic sides of a face: the option --periodic of cad2tri, and the pairs of curves that it names.

#include <optional>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

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

/// Fills face.periodic_pairs. The curves of a name or pattern are one chain or several, as many as on the other side. A
/// motion that maps a chain onto another one, reversed, is unique: it is found from their ends, such that all chains
/// fit best, unless it is given, and must fit within 1e-9 diameters. A joint of one side that the other one lacks is
/// made there; then the curves of the second side are replaced by the images of the first one's. Throws UsageError for
/// names that are not those of such chains, FormatError for curves that differ, with the place, the distance and a
/// remedy.
void pair_periodic_sides(CadFace& face, const std::vector<PeriodicRequest>& requests);

}  // namespace quadrille::cad
