#include "cli/version.hpp"

namespace quadrille::cli {

const char* const version = QUADRILLE_VERSION;

}  // namespace quadrille::cli
