#pragma once
// Boundary curves by the names that options use.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

/// The curves named `name` or, if no curve has that name, the curve of that number: of an interface the curves of both
/// regions, with "NAME@REGION" those of this region alone. Throws UsageError, which lists the
/// names, the nearest one first, if the face has no such curve; `option` is at the beginning of its message.
std::vector<int> named_curves(const CadFace& face, const std::string& name, const std::string& option);

/// The region that "NAME@REGION" picks; -1 if no region is named.
int named_region(const CadFace& face, const std::string& name);

}  // namespace quadrille::curve
