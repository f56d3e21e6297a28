#pragma once
// Sizes that follow the features of a face: at least a given number of elements along each of its boundary curves.
//
// A run is a part of the boundary between two consecutive corners or ends of given names. Along a run of length L the
// size is L / n; along a smooth closed loop, a hole, it is L / (3 n), because it has no ends at which elements begin.
// Runs shorter than a thousandth of the diameter per element count as so long: one tiny edge shall not make the mesh of
// the whole face fine.

#include <vector>

#include "model/cad_face.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// The least size along a curve, in diameters.
inline constexpr double least_curve_size = 1e-3;

/// The sources of sizes below `greatest`, none below `least`. `per_curve`: n > 0; `slope` > 0: growth of sizes per
/// distance.
std::vector<SizeSegment> segments_by_curves(const CadFace& face, int per_curve, double least, double greatest,
                                            double slope);

}  // namespace quadrille::sizing
