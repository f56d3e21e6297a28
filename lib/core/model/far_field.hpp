#pragma once
// Far fields: outlines whose curves are called `farfield`, and curves called `wake` that lead from a body to them
// (pipelines/points2step names them so).

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille {

/// The name of the boundary curves by which an outline is recognised as a far field.
inline constexpr const char* far_field_name = "farfield";

inline bool is_far_field(const CadFace& face, int curve) {
  return face.has_given_name(curve) && face.curve_names[curve] == far_field_name;
}

/// The name of the curves along which elements stay small downstream of a body.
inline constexpr const char* wake_name = "wake";

/// Whether the face has a curve of a far field.
inline bool has_far_field(const CadFace& face) {
  for (int curve = 0; curve < face.num_curves(); ++curve)
    if (is_far_field(face, curve)) return true;
  return false;
}

/// The curves of the face that are called `wake`.
inline std::vector<int> wake_curves(const CadFace& face) {
  std::vector<int> curves;
  for (int curve = 0; curve < face.num_curves(); ++curve)
    if (face.has_given_name(curve) && face.curve_names[curve] == wake_name) curves.push_back(curve);
  return curves;
}

}  // namespace quadrille
