#pragma once
// Moves a mesh before it is written: quadexport --translate.

#include <string>
#include <vector>

#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

/// The two or three numbers of "X,Y" or "X,Y,Z", lengths in the unit of the CAD file; none of an empty text. Throws
/// UsageError.
std::vector<double> parse_translation(const std::string& text);

/// Throws UsageError for three numbers in a plane.
void require_translation(const std::vector<double>& by, bool in_space);

/// Adds `by` to all positions as they are written: to x, y of the face's plane, or in space if `in_space` or where the
/// face is curved, with z = 0 for two numbers. Motions of periodic sides change with them. Throws UsageError as
/// require_translation.
void translate(QuadMesh& mesh, const std::vector<double>& by, bool in_space);

/// The same in space, whatever `in_space` is.
void translate(HexMesh& mesh, const std::vector<double>& by, bool in_space);

}  // namespace quadrille::exports
