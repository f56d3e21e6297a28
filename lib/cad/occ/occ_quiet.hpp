#pragma once
// Process-wide settings of OpenCASCADE.

namespace quadrille::occ {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

}  // namespace quadrille::occ
