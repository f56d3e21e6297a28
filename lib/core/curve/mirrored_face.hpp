#pragma once
// The face that one half of it and its mirror image make.

#include <string>
#include <vector>

#include "curve/symmetry_lines.hpp"
#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The whole, without the line of symmetry. It has the coordinates of the half, and no periodic sides.
struct MirroredFace {
  CadFace whole;
  // By curve of the half, -1 on the line: the curve of the whole that is the same, and the one that is its mirror
  // image, in the opposite direction on the same interval of parameters.
  std::vector<int> copy, image;
};

/// `half`: a face of which `line` is a line of symmetry. Regions that the line does not bound are followed
/// by their images.
MirroredFace mirrored_face(const CadFace& half, const SymmetryLine& line);

/// Whether the whole has a corner where the boundary of the half meets the line at this angle (radians): twice the
/// angle differs from 180 degrees by more than one.
bool is_corner_of_whole(double interior_angle);

/// The whole of which the face is one half or a quarter at the curves whose names fit these patterns; the face itself
/// if it is neither.
CadFace whole_of(CadFace face, const std::vector<std::string>& symmetry);

}  // namespace quadrille::curve
