#include "features/acts_as_corner.hpp"

#include <cmath>

#include "curve/nurbs.hpp"
#include "features/feature_constants.hpp"

namespace quadrille::features {

bool is_on_corner_fillet(const CadFace& face, const FeatureNode& node, double distance) {
  if (node.is_inside() || node.hole) return false;
  return std::abs(curve::curvature(face.curves[node.curve], node.t)) * feature_constants.corner_radius * distance > 1;
}

bool is_beside_corner_fillet(const BoundaryClearance& clearance, const FeatureNode& node, double distance) {
  return node.is_inside() && clearance.at(node.position) < feature_constants.corner_clearance * distance;
}

}  // namespace quadrille::features
