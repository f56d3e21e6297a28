#include "test_data.hpp"

#include <fstream>
#include <sstream>
#include <stdexcept>

namespace quadrille {

std::string test_data() { return TEST_DATA; }

std::string test_bytes(const std::string& file) {
  std::ifstream stream(test_data() + "/" + file, std::ios::binary);
  if (!stream) throw std::runtime_error("no " + file);
  std::ostringstream bytes;
  bytes << stream.rdbuf();
  return bytes.str();
}

}  // namespace quadrille
