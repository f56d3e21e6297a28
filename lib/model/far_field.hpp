#pragma once
// Far fields: outlines whose curves are called `farfield` (pipelines/points2step names them so).

#include "model/cad_face.hpp"

namespace quadrille {

/// The name of the boundary curves by which an outline is recognised as a far field.
inline constexpr const char* far_field_name = "farfield";

inline bool is_far_field(const CadFace& face, int curve) {
  return face.has_given_name(curve) && face.curve_names[curve] == far_field_name;
}

/// Whether the face has a curve of that name.
inline bool has_far_field(const CadFace& face) {
  for (int curve = 0; curve < face.num_curves(); ++curve)
    if (is_far_field(face, curve)) return true;
  return false;
}

}  // namespace quadrille
