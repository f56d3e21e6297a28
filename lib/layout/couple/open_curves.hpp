#pragma once
// Interfaces and slits that are open: nothing crosses them, and each side has nodes of its own.

#include <string>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::couple {

/// The face without the partners of the interfaces and slits of these names. Throws UsageError, which begins with
/// `option`, if a name is that of no curve, or of a curve without a partner.
CadFace with_open_curves(CadFace face, const std::vector<std::string>& names, const std::string& option);

/// The names of options NAME=nonconforming. Throws UsageError for others.
std::vector<std::string> nonconforming_interfaces(const std::vector<std::string>& options);

}  // namespace quadrille::couple
