#pragma once
// New names for the boundary curves of a face. No kernel here.

#include <vector>

#include "model/cad_face.hpp"
#include "model/name_rules.hpp"

namespace quadrille::cad {

/// Sets face.curve_names by `rules`; old names are those before the first change, and several curves may share a name.
/// Throws FormatError, with the rule's place, for a rule that meets no curve, a place that is equally near to several
/// curves (within 1e-6 diameters) or farther than a diameter from all, and for two rules that name the same curve.
void rename_curves(CadFace& face, const std::vector<NameRule>& rules);

}  // namespace quadrille::cad
