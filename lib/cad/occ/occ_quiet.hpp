#pragma once
// Process-wide settings of OpenCASCADE, and its writers run by them.

#include <Standard_Failure.hxx>
#include <string>

#include "base/error.hpp"

namespace quadrille::occ {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

/// The result of `write`, silently; errors of the kernel become ComputeErrors. `what`: what is written, for messages.
template <class Write>
std::string written_by_kernel(const std::string& what, Write write) {
  quiet_kernel();
  try {
    return write();
  } catch (const Standard_Failure& e) {
    throw ComputeError(what + " cannot be written as a CAD file: " + e.GetMessageString());
  }
}

}  // namespace quadrille::occ
