#pragma once

namespace quadrille {

/// The version of all tools, "0.1.0".
extern const char* const version;

}  // namespace quadrille
