#pragma once
// Which boundary curves an offset curve follows.

#include <vector>

#include "model/cad_face.hpp"
#include "offset/offset_request.hpp"

namespace quadrille::offset {

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
