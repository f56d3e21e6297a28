#pragma once
// The lines along which a face is one half, or one quarter, of a symmetric whole, and the whole.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// A line of symmetry in its direction along the boundary, so that the face is on its left.
struct SymmetryLine {
  Vec2 origin, direction;   ///< a point of it, and a unit vector
  std::vector<int> curves;  ///< of the face that lie on it, ascending

  /// The distance from the line, positive on the side of the face.
  double height(Vec2 x) const { return cross(direction, x - origin); }
  /// The image of a direction.
  Vec2 reflected(Vec2 d) const { return 2 * dot(d, direction) * direction - d; }
  /// The mirror image of a point.
  Vec2 operator()(Vec2 x) const { return origin + reflected(x - origin); }
};

/// The curves, without interfaces, whose names fit one of `patterns` (base/name_text.hpp), ascending.
std::vector<int> curves_that_fit(const CadFace& face, const std::vector<std::string>& patterns);

struct SymmetryLines {
  std::vector<SymmetryLine> lines;  ///< in the order of their first curves
  std::string fault;                ///< which curve can be no line of symmetry, where and why; then there are no lines
};

/// The lines on which these curves lie. Within 1e-6 diameters each must be straight, and the face on one side of it.
SymmetryLines symmetry_lines(const CadFace& face, const std::vector<int>& curves);

/// Whether the face is one half of a whole, at one line, or a quarter, at two lines at right angles.
bool is_part_of_whole(const std::vector<SymmetryLine>& lines);

/// The whole, without the line of symmetry. It has the coordinates of the half, and no periodic sides.
struct MirroredFace {
  CadFace whole;
  // By curve of the half, -1 on the line: the curve of the whole that is the same, and the one that is its mirror
  // image, in the opposite direction on the same interval of parameters.
  std::vector<int> copy, image;
};

/// `half`: a face of which `line` is a line of symmetry. Regions that the line does not bound are followed by their
/// images.
MirroredFace mirrored_face(const CadFace& half, const SymmetryLine& line);

/// Whether the whole has a corner where the boundary of the half meets the line at this angle (radians): twice the
/// angle differs from 180 degrees by more than one.
bool is_corner_of_whole(double interior_angle);

/// The whole of which the face is one half or a quarter at the curves whose names fit these patterns; the face itself
/// if it is neither.
CadFace whole_of(CadFace face, const std::vector<std::string>& symmetry);

}  // namespace quadrille::curve
