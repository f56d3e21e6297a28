#pragma once
// The feature size of a face when the user prescribes none.

#include <optional>
#include <string>

#include "model/cad_face.hpp"

namespace quadrille::features {

/// A five-hundredth of the diameter: blocks of that size at the usual element sizes (a twentieth) have elements of edge
/// ratios near 100. In a far field (model/special_names) the diameter is that of the box around the bodies, unless
/// curves at a distance from walls are embedded. At most half the mean width of the face, which is its area divided by
/// half its perimeter. It depends on the face alone, never on element sizes, so that refinement keeps the blocks.
double automatic_feature_size(const CadFace& face);

/// "auto", which gives std::nullopt, or a length, 0 for none. Throws UsageError.
std::optional<double> parse_feature_size(const std::string& text);

}  // namespace quadrille::features
