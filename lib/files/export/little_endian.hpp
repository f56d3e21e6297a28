#pragma once
// Binary output of numbers in little-endian byte order.

#include <bit>
#include <cstdint>
#include <string>
#include <type_traits>

namespace quadrille::exports {

/// Appends the 4 or 8 bytes of a number, the lowest first.
template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) == sizeof(Bits));
  const Bits bits = std::bit_cast<Bits>(number);
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xff);
}

}  // namespace quadrille::exports
