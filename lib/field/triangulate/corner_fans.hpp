#pragma once
// Geometric fans at the junctions where the field is singular (lib/method.md §3, "Layers"): apex triangles and rings of
// quads, each split in two, with radii R, R sigma, R sigma^2, ...
//
//        rim ______      Sectors of at most 60 degrees. Side vertices lie ON the two curves at the ring's distance from
//           /\  /\       the apex. The rim is a fixed constraint of the triangulation around it. A corner below 75 or
//          /__\/__\      above 285 degrees gets a single ring in any case: it keeps the refinement away from the small
//    curve   apex  curve angle between its curves; so do the corners at the tip of a body that slits (wakes) meet.
//    Along a fan the curves turn by at most the corner's angle together.

#include <span>
#include <vector>

#include "triangulate/curved_edges.hpp"
#include "triangulate/draft.hpp"
#include "triangulate/triangulate_options.hpp"

namespace quadrille::triangulate {

struct Fan {
  int junction = 0;
  double radius = 0;
  int num_sectors = 1;
  std::vector<double> radii;  ///< of the rings, innermost first
  std::vector<double> t_out;  ///< parameters of the side vertices on the outgoing curve, by ring
  std::vector<double> t_in;   ///< the same on the incoming curve
  std::vector<int> rim;       ///< vertices of the outermost ring, counter-clockwise: from outgoing to incoming curve
};

/// Limits of a boundary edge.
struct EdgeLimits {
  double size = 0;       ///< greatest length
  double turn = 0;       ///< greatest turn of the tangent, radians
  double curve_tol = 0;  ///< greatest distance between edge and curve, a length
};

/// Selects the junctions that need fans, and the radius and number of rings of each fan. Junctions in one place, at a
/// slit or where a region touches itself, have all a fan or none, with the same radii: fans share the vertices on
/// slits.
std::vector<Fan> plan_fans(const EdgeFit& fit, const TriangulateOptions& options, const EdgeLimits& limits);

/// Adds the vertices, triangles and boundary edges of the fans to the draft and sets their rims.
void build_fans(const Outline& outline, std::span<Fan> fans, Draft& draft);

}  // namespace quadrille::triangulate
