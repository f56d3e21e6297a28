#pragma once
// Names of the curves at a distance from walls that get blocks of their own (offset/embed_offsets.hpp).

#include <algorithm>
#include <string>

#include "model/cad_face.hpp"

namespace quadrille {

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
