#pragma once
// Which boundary curves an offset curve follows: what the option --offset of cad2tri names; and the tuned constants of
// curves at a distance from walls.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::offset {

struct OffsetConstants {
  // Which boundaries a curve follows (offset_chain).
  /// Radians. It ends on a boundary that meets the wall at an interior angle of at most this, and goes on along one
  /// that meets it at more.
  double greatest_end_angle = 2.356194490192345;
  /// Radians. A wall's corner of more than this has two corners of the curve opposite to it, with a straight line
  /// between them: the corner has four blocks around it, and an extended curve would run far away.
  double least_capped_angle = 5.497787143782138;

  // Where there is less room (offset_profile).
  /// The distance, of the radius of the circle that touches the wall and the nearest other place of the boundary: 0.35
  /// of the gap between parallel walls. Between both curves a third of it stays for intervals about as long as the last
  /// layers: there are as many as the blocks beyond the gap need to grow from the layers to the prescribed size.
  double share_of_facing_wall = 0.7;
  /// The same where the other place is no wall: 0.7 of the gap.
  double share_of_boundary = 1.4;
  /// At a corner above 180 degrees the curve is this many times as far away, in directions between both normals.
  double corner_reach = 1.4142135623730951;
  int corner_directions = 16;
  /// Greatest change of the distance per length along the wall.
  double greatest_slope = 0.15;
  /// The least distance, of the prescribed one; with less the layers would have no height.
  double least_ratio = 0.01;
  /// Samples of each curve per distance, and the limits of their number.
  double samples_per_distance = 4;
  int least_samples = 64, most_samples = 1024;

  // Curves.
  /// Diameters. A fitted spline is nowhere further from the exact curve.
  double fit_tolerance = 1e-7;
  int first_fit_intervals = 64, most_fit_intervals = 2048;
  /// Diameters. Points nearer to each other are one.
  double tolerance = 1e-8;
  /// Diameters. Where less is missing to a crossing, the curve's end moves there along its tangent; else a straight
  /// line follows.
  double least_extension = 1e-5;
  /// Diameters. The least prescribed distance.
  double least_distance = 1e-6;
};
inline constexpr OffsetConstants offset_constants;

struct OffsetRequest {
  std::vector<std::string> names;  ///< of boundary curves, or their numbers
  double distance = 0;             ///< a length, above 0
  std::string where;               ///< the option, for messages
};

/// "NAME=T" or "NAME,NAME=T". Throws UsageError, with the option, for anything else.
std::vector<OffsetRequest> offset_requests(const std::vector<std::string>& options);

/// Consecutive curves of a loop.
struct WallChain {
  std::vector<int> curves;        ///< in the order of the loop
  std::vector<double> distances;  ///< of each, a length
  std::vector<int> requests;      ///< of each: the request from which it has its distance
  bool is_closed = false;         ///< the first curve follows the last one
  /// One end, or both, is on a line of symmetry: the chain goes on with its mirror image.
  bool begins_on_line = false, ends_on_line = false;
};

/// By curve: the request that names it, or -1. Throws UsageError for a name that the face does not have, and for curves
/// that two requests name.
std::vector<int> requests_of_curves(const CadFace& face, const std::vector<OffsetRequest>& requests);

/// The chains of walls, by their first curves. A chain goes on along the neighbour of its last wall, with the same
/// distance, as long as both meet at an angle of more than OffsetConstants::greatest_end_angle and the neighbour is not
/// on a line of symmetry (`is_on_line`, by curve). Throws UsageError where walls that meet at such an angle below 225
/// degrees have different distances.
std::vector<WallChain> wall_chains(const CadFace& face, const std::vector<OffsetRequest>& requests,
                                   const std::vector<bool>& is_on_line);

}  // namespace quadrille::offset
