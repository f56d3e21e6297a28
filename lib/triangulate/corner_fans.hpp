#pragma once
// Geometric fans at the junctions where the field is singular (lib/method.md §3, "Layers"): apex triangles and rings of
// quads, each split in two, with radii R, R sigma, R sigma^2, ...
//
//        rim ______      Sectors of at most 60 degrees. Side vertices lie ON the two curves at the ring's distance from
//           /\  /\       the apex. The rim is a fixed constraint of the triangulation around it. A corner below 75
//          /__\/__\      degrees gets a single ring in any case: it keeps the refinement away from its small angle.
//    curve   apex  curve

#include <vector>

#include "triangulate/draft.hpp"
#include "triangulate/edge_fit.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

struct Fan {
  int junction = 0;
  double radius = 0;
  int num_sectors = 1;
  std::vector<double> radii;  ///< of the rings, innermost first
  std::vector<double> t_out;  ///< parameter of the side vertices on the outgoing curve, by ring
  std::vector<double> t_in;   ///< the same on the incoming curve
  std::vector<int> rim;       ///< vertices of the outermost ring, counter-clockwise: from outgoing to incoming curve
};

/// What a boundary edge may be.
struct EdgeLimits {
  double size = 0;       ///< greatest length
  double turn = 0;       ///< greatest turn, radians
  double curve_tol = 0;  ///< greatest error, a length
};

/// Where fans go, how large they are and how many rings they have.
std::vector<Fan> plan_fans(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits);

/// Adds vertices, triangles and boundary edges of `fan` and fills its rim.
void build_fan(const Outline& outline, Fan& fan, Draft& draft);

}  // namespace quadrille::triangulate
