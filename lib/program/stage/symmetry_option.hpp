#pragma once
// The option --symmetry of several stages: the curves at which the face is one half or a quarter of a symmetric whole.

#include <string>
#include <vector>

#include "base/options.hpp"
#include "base/report.hpp"
#include "model/cad_face.hpp"

namespace quadrille::stage {

void declare_symmetry(Options& options, std::vector<std::string>& names);

/// The names of the curves that the option means, without interfaces: those that fit what is given (a name, a pattern,
/// or the number of a curve), none for "none", without the option those that fit model/name_rules.hpp. Throws
/// UsageError for what fits no curve.
std::vector<std::string> symmetry_names(const CadFace& face, const std::vector<std::string>& given);

/// The same, but none if the face is neither a half nor a quarter at these curves (curve/symmetry_lines.hpp). That is
/// an error if they were given, and otherwise a warning (W-NODE-005) if they are bent or inside the face.
std::vector<std::string> checked_symmetry(const CadFace& face, const std::vector<std::string>& given, Report& report);

}  // namespace quadrille::stage
