#pragma once
// Names of boundary curves: rules for new ones (formats/boundary-names.md), also of blocks, and those with a meaning:
// `farfield` and `wake` (pipelines/points2step names curves so), `symmetry`, and those of curves at a distance from
// walls that get blocks of their own (offset/embed_offsets.hpp).

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

// Rules for new names of boundary curves (formats/boundary-names.md; a file, or --name) or blocks
// (formats/block-names.md).

/// One entry: the curves or blocks that get `name`.
struct NameRule {
  enum class Kind {
    key,       ///< `text` is an old name, or selects curves (curve/select_curves), or else is a number
    number,    ///< number of a curve or block, base 0
    old_name,  ///< all curves of the name `text`
    position,  ///< the curve nearest to the position `position`, or the block around it
    range,     ///< the numbers from `number` to `last_number`
    pattern,   ///< all curves that `text` selects, by wild cards, box(...) or circles(...) (curve/select_curves)
    rest,      ///< all that no other rule names; of curves those of the boundary, unless `part` is interface
  };
  /// Of the curves: the outline and holes of the whole face, or those that two regions share or that lie inside one.
  enum class Part { any, boundary, interface };
  Kind kind = Kind::rest;
  std::string text{};
  int number = -1;
  std::vector<double> position{};  ///< x, y of the face's plane (with face.origin), or x, y, z of the CAD model's space
  std::string name{};              ///< valid UTF-8, trimmed, not empty
  std::string where{};             ///< the file and the entry, or the option, for messages
  int last_number = -1;            ///< of a range
  double max_distance = 1;         ///< of a position from the curve, in diameters
  Part part = Part::any;           ///< of a pattern, or of the rest: what else fits is not meant
};

}  // namespace quadrille
