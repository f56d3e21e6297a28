#pragma once
// Sources of sizes along boundary curves.
//
// A constant size along a boundary acts from the exact circular arc. Other curves are cut into segments so short that
// neither their distance from the curve nor linear interpolation between their ends changes the size by a relative
// amount above 1e-5: sizes of mirror images agree although the starts of their curves differ.

#include <vector>

#include "model/cad_face.hpp"
#include "sizing/size_field.hpp"

namespace quadrille::sizing {

/// `size` along one curve. `slope` > 0: growth of sizes per distance from it.
std::vector<SizeSegment> segments_near(const Nurbs& curve, double size, double slope);

/// A size in proportion to the distance from one end of a chain of curves: `size` there, `other_size` at the other end.
struct GrowingSize {
  Vec2 end, other_end;
  double size = 0, other_size = 0;
};
/// The ends of the curves: their joint of least x (then y), and the one of greatest x (then y); equal within 1e-6
/// diameters.
GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size);
std::vector<SizeSegment> segments_near(const Nurbs& curve, const GrowingSize& size, double slope);

/// 2 pi / (elements_per_turn |curvature|) along one curve, between `least` and `greatest`; segments all at `greatest`
/// are omitted. Corners prescribe no size.
std::vector<SizeSegment> segments_by_curvature(const Nurbs& curve, double elements_per_turn, double least,
                                               double greatest, double slope);

/// sqrt(8 sag / |curvature|) along one curve, between `sag` and `greatest`, in the same way: the size of which the
/// straight edge is this distance away from the curve.
std::vector<SizeSegment> segments_by_sag(const Nurbs& curve, double sag, double greatest, double slope);

/// `sizes`, and at bends of the boundary, where a mapped element holds fewer polynomials, that of edges which turn by
/// 15 degrees, but at least three quarters of the greatest size (lib/method.md, section 10).
SizeField sizes_at_bends(const CadFace& face, const SizeField& sizes);

}  // namespace quadrille::sizing
