#pragma once
// Knots of splines that lie so close to each other that elements between them would be slivers.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::heal {

struct MergedKnots {
  Vec2 position;
  double length = 0;  ///< of the curve between the first and the last of them
};

/// Merges breaks of the curve (curve::smoothness_breaks) with each other, or with an end of the curve, where the curve
/// between them is at most `most` long, a length: their knots become one knot, which loses poles if its multiplicity
/// exceeds the degree. The ends stay; other points move by less than the length. Returns the longest stretch between
/// merged breaks. Returns std::nullopt, and leaves the curve unchanged, if no breaks are so near to each other, or if
/// the whole curve is no longer than `most`.
std::optional<MergedKnots> merge_knots(Nurbs& curve, double most);

}  // namespace quadrille::heal
