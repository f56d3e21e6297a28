#pragma once
// Renames the boundary curves of a face. No OpenCASCADE types.

#include <vector>

#include "model/cad_face.hpp"
#include "model/name_rules.hpp"

namespace quadrille::cad {

/// Sets face.curve_names by `rules`; old names refer to the names before the first rule, and several curves may have
/// the same name. Throws FormatError, with the position of the rule in its source, for a rule that matches no curve,
/// for a position that is equally near to several curves (within 1e-6 diameters) or farther than a diameter from all,
/// and for two rules that name the same curve.
void rename_curves(CadFace& face, const std::vector<NameRule>& rules);

}  // namespace quadrille::cad
