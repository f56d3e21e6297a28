#pragma once
// OpenCASCADE's manners.

namespace quadrille {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

}  // namespace quadrille
