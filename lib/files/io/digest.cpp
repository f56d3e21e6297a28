#include "io/digest.hpp"

#include <array>
#include <bit>
#include <cstdint>
#include <cstring>

// clang-format would move these out of their condition
// clang-format off
#ifdef __x86_64__
#include <cpuid.h>
#include <immintrin.h>
#endif
// clang-format on

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

constexpr std::array<std::uint32_t, 64> constants{
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2};

using State = std::array<std::uint32_t, 8>;

std::uint32_t big_endian(const unsigned char* p) {
  return std::uint32_t{p[0]} << 24 | std::uint32_t{p[1]} << 16 | std::uint32_t{p[2]} << 8 | std::uint32_t{p[3]};
}

void add_block(State& state, const unsigned char* block) {
  std::array<std::uint32_t, 64> w;
  for (std::size_t t = 0; t < 16; ++t) w[t] = big_endian(block + 4 * t);
#pragma GCC unroll 16
  for (std::size_t t = 16; t < 64; ++t) {
    const std::uint32_t a = w[t - 15], b = w[t - 2];
    w[t] = w[t - 16] + (std::rotr(a, 7) ^ std::rotr(a, 18) ^ (a >> 3)) + w[t - 7] +
           (std::rotr(b, 17) ^ std::rotr(b, 19) ^ (b >> 10));
  }
  auto [a, b, c, d, e, f, g, h] = state;
#pragma GCC unroll 8  // after eight rounds every letter is back in its register, so no moves are needed
  for (std::size_t t = 0; t < 64; ++t) {
    const std::uint32_t t1 =
        h + (std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25)) + ((e & f) ^ (~e & g)) + constants[t] + w[t];
    const std::uint32_t t2 = (std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
    h = g, g = f, f = e, e = d + t1, d = c, c = b, b = a, a = t1 + t2;
  }
  const State added{a, b, c, d, e, f, g, h};
  for (std::size_t i = 0; i < 8; ++i) state[i] += added[i];
}

void add_blocks_in_software(State& state, const unsigned char* data, std::size_t num_blocks) {
  for (std::size_t i = 0; i < num_blocks; ++i) add_block(state, data + 64 * i);
}

#ifdef __x86_64__
/// The same by the processor's own instructions, four rounds at a time: without them hashing took a fifth of the run
/// time of a short tool.
__attribute__((target("sha,sse4.1"))) void add_blocks_in_hardware(State& state, const unsigned char* data,
                                                                  std::size_t num_blocks) {
  const __m128i byte_swap = _mm_set_epi8(12, 13, 14, 15, 8, 9, 10, 11, 4, 5, 6, 7, 0, 1, 2, 3);
  // The instructions keep the state as words (f, e, b, a) and (h, g, d, c).
  const auto load = [](const std::uint32_t* p) { return _mm_loadu_si128(reinterpret_cast<const __m128i*>(p)); };
  const __m128i badc = _mm_shuffle_epi32(load(state.data()), 0xb1), hgfe = _mm_shuffle_epi32(load(&state[4]), 0x1b);
  __m128i feba = _mm_alignr_epi8(badc, hgfe, 8), hgdc = _mm_blend_epi16(hgfe, badc, 0xf0);
  for (std::size_t block = 0; block < num_blocks; ++block, data += 64) {
    const __m128i feba_before = feba, hgdc_before = hgdc;
    __m128i w[16];
    for (std::size_t i = 0; i < 16; ++i) {
      if (i < 4)
        w[i] = _mm_shuffle_epi8(_mm_loadu_si128(reinterpret_cast<const __m128i*>(data + 16 * i)), byte_swap);
      else
        w[i] = _mm_sha256msg2_epu32(
            _mm_add_epi32(_mm_sha256msg1_epu32(w[i - 4], w[i - 3]), _mm_alignr_epi8(w[i - 1], w[i - 2], 4)), w[i - 1]);
      const __m128i sum = _mm_add_epi32(w[i], load(&constants[4 * i]));
      hgdc = _mm_sha256rnds2_epu32(hgdc, feba, sum);
      feba = _mm_sha256rnds2_epu32(feba, hgdc, _mm_shuffle_epi32(sum, 0x0e));
    }
    feba = _mm_add_epi32(feba, feba_before);
    hgdc = _mm_add_epi32(hgdc, hgdc_before);
  }
  const __m128i abef = _mm_shuffle_epi32(feba, 0x1b), dchg = _mm_shuffle_epi32(hgdc, 0xb1);
  _mm_storeu_si128(reinterpret_cast<__m128i*>(state.data()), _mm_blend_epi16(abef, dchg, 0xf0));
  _mm_storeu_si128(reinterpret_cast<__m128i*>(&state[4]), _mm_alignr_epi8(dchg, abef, 8));
}
#endif

using AddBlocks = void (*)(State&, const unsigned char*, std::size_t);

AddBlocks fastest() {
#ifdef __x86_64__
  unsigned a = 0, b = 0, c = 0, d = 0;
  constexpr unsigned sha = 1u << 29;  // leaf 7, EBX
  if (__get_cpuid_count(7, 0, &a, &b, &c, &d) && (b & sha) && __builtin_cpu_supports("sse4.1"))
    return add_blocks_in_hardware;
#endif
  return add_blocks_in_software;
}

std::string digest(std::string_view bytes, AddBlocks add_blocks) {
  State state{0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a, 0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19};
  const auto* data = reinterpret_cast<const unsigned char*>(bytes.data());
  const std::size_t num_whole = bytes.size() / 64, rest = bytes.size() % 64;
  add_blocks(state, data, num_whole);
  // The end: a one bit, zeros, and the length in bits in the last eight bytes.
  std::array<unsigned char, 128> tail{};
  if (rest > 0) std::memcpy(tail.data(), data + 64 * num_whole, rest);
  tail[rest] = 0x80;
  const std::size_t tail_size = rest < 56 ? 64 : 128;
  const std::uint64_t num_bits = std::uint64_t{bytes.size()} * 8;
  for (std::size_t i = 0; i < 8; ++i) tail[tail_size - 1 - i] = static_cast<unsigned char>(num_bits >> (8 * i));
  add_blocks(state, tail.data(), tail_size / 64);

  constexpr char digits[] = "0123456789abcdef";
  std::string out;
  for (const std::uint32_t word : state)
    for (int shift = 28; shift >= 0; shift -= 4) out += digits[(word >> shift) & 15];
  return out;
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
  return has_mark && has_sum ? Checksum::right
                             : Checksum::wrong;  // the right sum without the checksum_mark: a damaged checksum_mark
}

// FIPS 180-4 in a few lines instead of libcrypto: loading that library costs more than hashing any stage file.

std::string sha256_hex(std::string_view bytes) { return digest(bytes, fastest()); }

std::string sha256_hex_in_software(std::string_view bytes) { return digest(bytes, add_blocks_in_software); }

}  // namespace quadrille::io
