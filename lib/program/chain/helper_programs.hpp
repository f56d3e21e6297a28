#pragma once
// Commands that belong to quadmesh.

#include <string>

namespace quadrille::chain {

/// The path of a command: beside this program or, for those that are no compiled programs, in the folder `pipelines` of
/// a source tree.
std::string command_path(const std::string& name);

}  // namespace quadrille::chain
