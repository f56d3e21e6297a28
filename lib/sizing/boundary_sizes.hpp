#pragma once
// Boundary curves as sources of sizes: the same size all along, or one that follows the curvature.
//
// Curves are cut into segments so short that neither their distance from the curve nor linear interpolation between
// their ends changes the size by a relative amount above 1e-5: sizes of mirror images agree although the starts of
// their curves differ.

#include <string>
#include <vector>

#include "model/cad_face.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// The curves named `name` or, if no curve has that name, the curve of that number: of an interface the curves of both
/// regions, with "NAME@REGION" those of this region alone. Throws UsageError, which lists the
/// names, the nearest one first, if the face has no such curve; `option` is at the beginning of its message.
std::vector<int> named_curves(const CadFace& face, const std::string& name, const std::string& option);

/// The region that "NAME@REGION" picks; -1 if no region is named.
int named_region(const CadFace& face, const std::string& name);

/// `size` along one curve. `slope` > 0: growth of sizes per distance from it.
std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope);

/// 2 pi / (elements_per_turn |curvature|) along one curve, between `least` and `greatest`; segments all at `greatest`
/// are omitted. Corners prescribe no size.
std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope);

}  // namespace quadrille::sizing
