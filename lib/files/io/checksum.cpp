#include "io/checksum.hpp"

#include <cstdint>
#include <cstring>

namespace quadrille::io {

namespace {

constexpr std::string_view checksum_mark = "QUADSUM1";

/// FNV-1a over little-endian words of 8 bytes (the last one padded with zeros), then the length. Every step is a
/// bijection of the state, so one damaged word is always detected.
std::uint64_t checksum(std::string_view bytes) {
  std::uint64_t state = 14695981039346656037ull;
  const auto mix = [&](std::uint64_t word) { state = (state ^ word) * 1099511628211ull; };
  std::size_t i = 0;
  for (; i + 8 <= bytes.size(); i += 8) {
    std::uint64_t word = 0;
    std::memcpy(&word, bytes.data() + i, 8);
    mix(word);
    state ^= state >> 29;  // mixes the high bits into the low ones
  }
  std::uint64_t rest = 0;
  std::memcpy(&rest, bytes.data() + i, bytes.size() - i);
  mix(rest);
  mix(bytes.size());
  return state;
}

std::string trailer_of(std::string_view image) {
  std::string trailer(checksum_mark);
  const std::uint64_t sum = checksum(image);
  for (int i = 0; i < 8; ++i) trailer += static_cast<char>((sum >> (8 * i)) & 0xff);
  return trailer;
}

}  // namespace

void append_checksum(std::string& image) { image += trailer_of(image); }

Checksum verify_checksum(const std::string& bytes, std::string_view& image) {
  image = bytes;
  if (bytes.size() < checksum_size) return Checksum::missing;
  const std::string_view sealed = image.substr(0, bytes.size() - checksum_size), trailer = image.substr(sealed.size());
  const std::string expected = trailer_of(sealed);
  const bool has_mark = trailer.substr(0, checksum_mark.size()) == checksum_mark;
  const bool has_sum = trailer.substr(checksum_mark.size()) == std::string_view(expected).substr(checksum_mark.size());
  if (!has_mark && !has_sum) return Checksum::missing;
  image = sealed;
  return has_mark && has_sum ? Checksum::right : Checksum::wrong;  // the right sum without the checksum_mark: a damaged checksum_mark
}

}  // namespace quadrille::io
