#pragma once
// The files of tests/data. In a source of its own, so that one object file alone holds the path.

#include <string>

namespace quadrille {

/// The absolute path of tests/data, without a slash at its end.
std::string test_data();

/// The bytes of a file of tests/data. Throws std::runtime_error.
std::string test_bytes(const std::string& file);

}  // namespace quadrille
