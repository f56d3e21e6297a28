#pragma once
// Process-wide settings of OpenCASCADE.

namespace quadrille::cad {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

}  // namespace quadrille::cad
