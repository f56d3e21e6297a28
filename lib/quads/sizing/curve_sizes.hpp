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

/// A curve from which sizes act: in the plane or, of a curved face, in space. The curve must outlive it.
class SourceCurve {
 public:
  SourceCurve(const Nurbs& curve) : plane_(&curve) {}       // NOLINT: either is a curve
  SourceCurve(const SpaceCurve& curve) : space_(&curve) {}  // NOLINT
  /// A boundary curve of a face.
  SourceCurve(const CadFace& face, int curve) {
    if (face.chart)
      space_ = &face.chart->space_curves[curve];
    else
      plane_ = &face.curves[curve];
  }

  const std::vector<double>& knots() const { return plane_ ? plane_->knots : space_->knots; }
  bool is_straight() const { return (plane_ ? plane_->degree : space_->degree) == 1; }
  const Nurbs* in_plane() const { return plane_; }  ///< null: in space
  std::size_t num_poles() const { return plane_ ? plane_->poles.size() : space_->poles.size(); }
  Vec3 pole(std::size_t i) const { return plane_ ? in_space(plane_->poles[i]) : space_->poles[i]; }
  Vec3 at(double t) const;
  double curvature(double t, bool from_left) const;  ///< >= 0; at knots from the right or from the left

 private:
  const Nurbs* plane_ = nullptr;
  const SpaceCurve* space_ = nullptr;
};

/// `size` along one curve. `slope` > 0: growth of sizes per distance from it.
std::vector<SizeSegment> segments_near(const SourceCurve& curve, double size, double slope);

/// A size in proportion to the distance from one end of a chain of curves: `size` there, `other_size` at the other end.
struct GrowingSize {
  Vec3 end, other_end;
  double size = 0, other_size = 0;
};
/// The ends of the curves: their joint of least x (then y, then z), and the one of greatest x; equal within 1e-6
/// diameters. Of a curved face the coordinates are those of space.
GrowingSize growing_size(const CadFace& face, const std::vector<int>& curves, double size, double other_size);
std::vector<SizeSegment> segments_near(const SourceCurve& curve, const GrowingSize& size, double slope);

/// 2 pi / (elements_per_turn |curvature|) along one curve, between `least` and `greatest`; segments all at `greatest`
/// are omitted. Corners prescribe no size.
std::vector<SizeSegment> segments_by_curvature(const SourceCurve& curve, double elements_per_turn, double least,
                                               double greatest, double slope);

/// sqrt(8 sag / |curvature|) along one curve, between `sag` and `greatest`, in the same way: the size of which the
/// straight edge is this distance away from the curve.
std::vector<SizeSegment> segments_by_sag(const SourceCurve& curve, double sag, double greatest, double slope);

/// `sizes`, and at bends of the boundary, where a mapped element holds fewer polynomials, that of edges which turn by
/// 15 degrees, but at least three quarters of the greatest size (lib/method.md, section 10).
SizeField sizes_at_bends(const CadFace& face, const SizeField& sizes);

}  // namespace quadrille::sizing
