#pragma once
// Rule "separate": irregular nodes nearer to each other than half the feature size are pushed apart.

#include <vector>

#include "curve/face_boundary.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features {

/// The point of one boundary curve nearest to a given point of the plane.
struct CurveFoot {
  Vec2 position;
  double distance = 0;
  bool is_reflex = false;  ///< the boundary turns away from the domain there
};

/// The nearest point of each curve that is nearer than `reach`; a point that several curves share appears once.
std::vector<CurveFoot> feet_of(const curve::FaceBoundary& boundary, Vec2 x, double reach);

/// Pushes inner nodes away from other nodes nearer than half the feature size (two inner nodes by equal amounts), and
/// inner nodes that were changed away from boundaries that are not reflex. Reflex boundary stops a node that is nearer
/// to it than at first and than half the feature size. Boundary nodes stay at their feature. All nodes move at once in
/// each round, so that symmetric sets stay symmetric, and the result is the round with the least shortfall. Records
/// each move, and the pairs and nodes whose clearance is too small.
void separate_nodes(FeatureState& state, const curve::FaceBoundary& boundary);

}  // namespace quadrille::features
