#pragma once
// The position of the face in space: coordinates of its plane, or of the CAD model.

#include <array>

#include "model/cad_face.hpp"

namespace quadrille::exports {

/// x3d = origin + x e_x + y e_y, in the unit of the file.
struct Frame {
  std::array<double, 3> origin{0, 0, 0}, x_axis{1, 0, 0}, y_axis{0, 1, 0};

  /// A position relative to face.origin, as all stage files store them.
  std::array<double, 3> at(Vec2 x) const {
    return {origin[0] + x.x * x_axis[0] + x.y * y_axis[0], origin[1] + x.x * x_axis[1] + x.y * y_axis[1],
            origin[2] + x.x * x_axis[2] + x.y * y_axis[2]};
  }

  /// Whether z = 0 everywhere and the orientation is kept, so that two coordinates suffice.
  bool is_plane() const {
    return origin[2] == 0 && x_axis[2] == 0 && y_axis[2] == 0 && x_axis[0] * y_axis[1] > x_axis[1] * y_axis[0];
  }
};

/// The face's own plane, z = 0.
inline Frame plane_frame(const CadFace& face) { return {{face.origin.x, face.origin.y, 0}, {1, 0, 0}, {0, 1, 0}}; }

/// The CAD model's space (CadFace: plane_origin, plane_x, plane_y).
inline Frame model_frame(const CadFace& face) {
  Frame frame{face.plane_origin, face.plane_x, face.plane_y};
  frame.origin = frame.at(face.origin);
  return frame;
}

}  // namespace quadrille::exports
