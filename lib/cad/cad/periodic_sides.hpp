#pragma once
// Periodic sides of a face, from the names of their curves.

#include <vector>

#include "cad/periodic_options.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

/// Fills face.periodic_pairs. The curves of a name or pattern are one chain or several, as many as on the other side. A
/// motion that maps a chain onto another one, reversed, is unique: it is found from their ends, such that all chains
/// fit best, unless it is given, and must fit within 1e-9 diameters. A joint of one side that the other one lacks is
/// made there; then the curves of the second side are replaced by the images of the first one's. Throws UsageError for
/// names that are not those of such chains, FormatError for curves that differ, with the place, the distance and a
/// remedy.
void pair_periodic_sides(CadFace& face, const std::vector<PeriodicRequest>& requests);

}  // namespace quadrille::cad
