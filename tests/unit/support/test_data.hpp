#pragma once
// Where tests/data lies. A function of its own, so that one object file alone holds the path.

#include <string>

namespace quadrille {

/// The absolute path of tests/data, without a slash at its end.
std::string test_data();

}  // namespace quadrille
