#pragma once
// Distances from points to the boundary of a face, curve by curve.

#include <vector>

#include "curve/pole_box.hpp"
#include "model/cad_face.hpp"

namespace quadrille::features {

/// The point of one boundary curve nearest to a given point of the plane.
struct CurveFoot {
  Vec2 position;
  double distance = 0;
  bool is_reflex = false;  ///< the boundary turns away from the domain there
};

class BoundaryClearance {
 public:
  /// `face` must outlive the object.
  explicit BoundaryClearance(const CadFace& face);

  /// Distance from x to the nearest point of the boundary.
  double at(Vec2 x) const;
  /// The nearest point of each curve that is nearer than `reach`; a point that several curves share appears once.
  std::vector<CurveFoot> feet(Vec2 x, double reach) const;
  /// Whether the segment from a to b, both inside, lies inside. The length of each step along it is the clearance,
  /// which must exceed 1e-9 diameters everywhere.
  bool is_segment_inside(Vec2 a, Vec2 b) const;

 private:
  const CadFace* face_;
  std::vector<curve::PoleBox> boxes_;
};

}  // namespace quadrille::features
