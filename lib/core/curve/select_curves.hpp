#pragma once
// Selects curves of a face by a pattern of names, a box, the diameter of circles, or as continuations of others, for
// options and files of users.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The curves that `text` selects, ascending. Those of this very name come first; if there are none:
///   - box(X0,Y0,X1,Y1): all that lie in a rectangle of the face's plane, whose corners are positions as face_position
///     takes them; box(X0,Y0,Z0,X1,Y1,Z1): in a box of the CAD model's space;
///   - circles(<D), circles(>D), circles(D): the curves of loops that are whole circles, of a diameter below, above or
///     within a thousandth of D, a length of the face; circles(): all of them;
///   - tangent(N), tangent(NAME): the curve of this number, or what the text in the brackets selects, and all that
///   continue
///     it without a corner, as far as they go: at an end of one, another leads on, with a change of direction of at
///     most a degree, or of what --corner-angle took for no corner. Of an interface both sides;
///   - else those whose name fits `text` with the wild cards * and ? (base/name_text).
/// Throws UsageError, with a message that begins with `where`, for a box, circles or a tangent() that cannot be
/// read, and for a box in the plane if the face is curved.
std::vector<int> selected_curves(const CadFace& face, const std::string& text, const std::string& where);

/// The curves whose name was made from this number, which offset curves may have changed since; else the curve of this
/// number, if there is one.
std::vector<int> curves_of_number(const CadFace& face, int number);

}  // namespace quadrille::curve
