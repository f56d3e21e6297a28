#pragma once
// The options --name and --region-name of cad2tri (formats/boundary-names.md, "On the command line"): names of boundary
// curves and of regions without a file.

#include <string>
#include <vector>

#include "model/name_rules.hpp"

namespace quadrille::cad {

/// The greatest distance of a point of --name from its curve, in diameters: a point farther away was taken from another
/// picture, or is in another unit.
constexpr double max_option_distance = 0.1;

/// One rule for each item of "NAME=LIST", a list of numbers, ranges a-b, names and patterns (base/name_text), or for
/// "NAME@X,Y[,Z]". The item "*" is the rest; "boundary:" and "interface:" before a pattern or "*" are its part. Throws
/// UsageError, with the option, for anything else. `option_name`: for messages.
std::vector<NameRule> name_option_rules(const std::vector<std::string>& options,
                                        const std::string& option_name = "--name");

}  // namespace quadrille::cad
