#include "base/version.hpp"

namespace quadrille {

const char* const version = QUADRILLE_VERSION;

}  // namespace quadrille
