#pragma once
// Names of boundary curves with a meaning: `farfield` and `wake` (pipelines/points2step names curves so), `symmetry`,
// and those of curves at a distance from walls that get blocks of their own (offset/embed_offsets.hpp).

#include <algorithm>
#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille {

/// The name of the boundary curves by which an outline is recognised as a far field.
inline constexpr const char* far_field_name = "farfield";

inline bool is_far_field(const CadFace& face, int curve) {
  return face.has_given_name(curve) && face.curve_names[curve] == far_field_name;
}

/// Pattern of the names of curves on lines at which the face is one half, or a quarter, of a symmetric whole.
inline constexpr const char* symmetry_pattern = "symmetry*";

/// The name of the curves along which elements stay small downstream of a body.
inline constexpr const char* wake_name = "wake";

/// Whether the face has a curve of a far field, around the bodies in an outer flow.
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

/// The name of the curve at a distance from the wall of this name.
inline std::string offset_name(const std::string& wall) { return wall + "_offset"; }

/// Whether the name is that of a curve at a distance from a wall.
inline bool is_offset_name(const std::string& name) { return name.ends_with(offset_name("")); }

/// Whether a curve of this name has an offset curve in the face.
inline bool has_offset(const CadFace& face, const std::string& wall) {
  return std::find(face.curve_names.begin(), face.curve_names.end(), offset_name(wall)) != face.curve_names.end();
}

/// Whether a face of one region lies between walls and their offset curves.
inline bool is_along_walls(const CadFace& region) {
  return std::any_of(region.curve_names.begin(), region.curve_names.end(),
                     [&](const std::string& name) { return has_offset(region, name); });
}

}  // namespace quadrille
