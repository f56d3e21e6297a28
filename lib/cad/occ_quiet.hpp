#pragma once
// OpenCASCADE's manners.

namespace quadrille::cad {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

}  // namespace quadrille::cad
