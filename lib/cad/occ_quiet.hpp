#pragma once
// Settings of OpenCASCADE for the whole process.

namespace quadrille::cad {

/// Stops OpenCASCADE from printing to stdout and stderr.
void quiet_kernel();

}  // namespace quadrille::cad
