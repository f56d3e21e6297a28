#pragma once
// The connected curves at a distance from a chain of walls: the offset of each curve, extended or cut at the next one.

#include <optional>
#include <string>
#include <vector>

#include "heal/raw_face.hpp"
#include "model/cad_face.hpp"
#include "offset/chart_heights.hpp"
#include "offset/offset_profile.hpp"

namespace quadrille::offset {

class ExtendedCurve {
 public:
  /// Stores a pointer to `curve`, which must outlive the object.
  explicit ExtendedCurve(const Nurbs& curve) : curve_(&curve) {}

  const Nurbs& curve() const { return *curve_; }
  Vec2 point(double t) const;
  Vec2 derivative(double t) const;
  /// The parameter at about this length beyond the beginning or, with a negative length, before it; the same at the
  /// end.
  double beside_start(double length) const;
  double beside_end(double length) const;

 private:
  const Nurbs* curve_;
};

struct ExtendedCrossing {
  double t_a = 0, t_b = 0;  ///< parameters on both curves
  Vec2 position;
};

/// The crossing that Newton's method finds from these parameters, within `tolerance`, a length; std::nullopt if none.
std::optional<ExtendedCrossing> crossing_near(const ExtendedCurve& a, double t_a, const ExtendedCurve& b, double t_b,
                                              double tolerance);

// The connected curves at a distance from a chain of walls.
//
// Both ends of each wall's offset curve are cut, or extended straight, where it crosses the next one. At a corner of
// more than OffsetConstants::least_capped_angle they are extended to a straight line across the bisector, at the
// distance from the corner. The ends of a chain that is not closed lie on the neighbouring boundaries; on
// a line of symmetry the chain and its mirror image make a corner, with half of a straight line across it.

/// In the order of the chain, each ending where the next one starts; bit for bit, unless on the boundary. Names are
/// those of the walls, with "_offset". Throws ComputeError, with the request and the place, where curves do not cross,
/// or not between their other ends: the distance is too great. Tolerances in diameters of the face.
std::vector<heal::LoopCurve> offset_chain(const CadFace& face, const WallChain& chain, const ChainProfile& profile,
                                          const ChartHeights& heights, const std::vector<OffsetRequest>& requests);

}  // namespace quadrille::offset
