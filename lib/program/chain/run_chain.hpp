#pragma once
// quadmesh: a CAD file, or points, in; a mesh out (README, "One command").

#include <string>
#include <vector>

namespace quadrille::chain {

/// Runs the command line, the name of the program left out; returns the exit code.
int run_chain(const std::vector<std::string>& arguments);

}  // namespace quadrille::chain
