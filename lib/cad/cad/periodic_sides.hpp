#pragma once
// Periodic sides of a face: the pairs of curves that the option --periodic of cad2tri names.

#include <vector>

#include "cad/periodic_options.hpp"
#include "model/cad_face.hpp"

namespace quadrille::cad {

/// Fills face.periodic_pairs. The curves of a name or pattern are one chain or several, as many as on the other side. A
/// motion that maps a chain onto another one, reversed, is unique: it is found from their ends, such that all chains
/// fit best, unless it is given, and must fit within 1e-9 diameters. A joint of one side that the other one lacks is
/// made there; then the curves of the second side are replaced by the images of the first one's. On a curved face all
/// of this is done in space (cad/periodic_in_space.hpp). Throws UsageError for names that are not those of such chains
/// and for motions that are given for a curved face, FormatError for curves that differ, with the place, the distance
/// and a remedy.
void pair_periodic_sides(CadFace& face, const std::vector<PeriodicRequest>& requests);

}  // namespace quadrille::cad
