#pragma once
// The corners of a face around which there is more of the face.

#include <vector>

#include "base/point_grid.hpp"
#include "base/tolerance.hpp"
#include "model/cad_face.hpp"

namespace quadrille {

/// By joint: whether more of the face is there than the sector of this joint, or a slit ends there. A slit ends, bends
/// or branches, or a region touches itself: beyond the corner there may be the face again.
inline std::vector<bool> enclosed_joints(const CadFace& face) {
  std::vector<Vec2> positions;
  for (const Joint& joint : face.joints) positions.push_back(joint.position);
  const std::vector<int> places = places_of(positions, tolerance::round_off * face.diameter);
  std::vector<bool> are_enclosed(places.size(), false);
  for (int j = 0; j < static_cast<int>(places.size()); ++j) {
    if (places[j] != j) are_enclosed[j] = are_enclosed[places[j]] = true;
    if (face.is_interface(j) && face.partners[j] == face.previous_in_loop(j)) are_enclosed[j] = true;
  }
  return are_enclosed;
}

}  // namespace quadrille
