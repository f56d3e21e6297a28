#pragma once
// Limits of a process that a call of the system met.

#include <string>

namespace quadrille {

/// Throws ComputeError if `error` (errno) says that the process has no more processes, open files or memory: "WHAT: no
/// more open files: raise their limit (ulimit -n)". Otherwise does nothing.
void require_resources(int error, const std::string& what);

}  // namespace quadrille
