#pragma once
// Numbers of Nek5000's binary files, for the tests of both.

#include <cstdint>
#include <cstring>
#include <string>
#include <vector>

namespace quadrille::exports {

inline const std::string mark = "\xFA\x61\xD1\x40";  ///< 6.54321 in single precision

/// Little-endian doubles, put together byte by byte.
inline std::vector<double> numbers(const std::string& bytes, std::size_t at, std::size_t count) {
  std::vector<double> found;
  for (std::size_t n = 0; n < count; ++n) {
    std::uint64_t bits = 0;
    for (std::size_t k = 0; k < 8; ++k)
      bits |= static_cast<std::uint64_t>(static_cast<unsigned char>(bytes.at(at + 8 * n + k))) << (8 * k);
    double number = 0;
    std::memcpy(&number, &bits, 8);
    found.push_back(number);
  }
  return found;
}

}  // namespace quadrille::exports
