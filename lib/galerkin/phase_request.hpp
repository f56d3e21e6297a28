#pragma once
// Whether a file's irregular nodes and corner valences can be had on a face.

#include <string>

#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"

namespace quadrille::galerkin {

/// Throws FormatError that begins with `name`, the file's, and says what and where:
/// - a corner or boundary node whose blocks would have angles omega / V outside [15, 165] degrees (V = 0 is degenerate
///   and allowed: it is divided later);
/// - valences that do not add up to 4 chi, with the arithmetic;
/// - nodes that are not inside the face, corners and curves that do not exist or are listed twice (PhaseBoundary).
void require_possible(const CadFace& face, const PhaseNodes& asked, const std::string& name);

}  // namespace quadrille::galerkin
