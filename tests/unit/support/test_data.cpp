#include "test_data.hpp"

namespace quadrille {

std::string test_data() { return TEST_DATA; }

}  // namespace quadrille
