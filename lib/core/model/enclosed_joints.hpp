#pragma once
// The corners of a face around which there is more of the face.

#include <vector>

#include "base/point_grid.hpp"
#include "base/tolerance.hpp"
#include "model/cad_face.hpp"

namespace quadrille {

/// By joint: whether more of the face is there than the sector of this joint, or a slit ends there. A slit ends, bends
/// or branches, or a region touches itself: beyond the corner there may be the face again. All sectors of a region in
/// one place are in one loop.
inline std::vector<bool> enclosed_joints(const CadFace& face) {
  std::vector<bool> are_enclosed(face.joints.size(), false);
  for (int l = 0; l < face.num_loops(); ++l) {
    const int first = face.loop_offsets[l];
    std::vector<Vec2> positions;
    for (int j = first; j < face.loop_offsets[l + 1]; ++j) positions.push_back(face.joints[j].position);
    const std::vector<int> places = places_of(positions, tolerance::round_off * face.diameter);
    for (int i = 0; i < static_cast<int>(places.size()); ++i) {
      const int joint = first + i;
      if (places[i] != i) are_enclosed[joint] = are_enclosed[first + places[i]] = true;
      if (face.is_interface(joint) && face.partners[joint] == face.previous_in_loop(joint)) are_enclosed[joint] = true;
    }
  }
  return are_enclosed;
}

}  // namespace quadrille
