#include "export/nek_bytes.hpp"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace quadrille::exports {

namespace {

constexpr float byte_order_mark = 6.54321F;

/// Appends the 4 or 8 bytes of a number, the lowest first.
template <class Number>
void append_little_endian(std::string& bytes, Number number) {
  using Bits = std::conditional_t<sizeof(Number) == 8, std::uint64_t, std::uint32_t>;
  static_assert(sizeof(Number) == sizeof(Bits));
  const Bits bits = std::bit_cast<Bits>(number);
  for (std::size_t k = 0; k < sizeof(Bits); ++k) bytes += static_cast<char>((bits >> (8 * k)) & 0xff);
}

constexpr std::size_t header_length = 132;

/// Word size, points in each direction, elements here and in all, time, step, file and number of files, contents,
/// thermodynamic pressure, no pressure on the velocity's points.
std::string field_header(int width, int dim, std::size_t count) {
  std::string line =
      fmt::format("#std {:1} {:2} {:2} {:2} {:10} {:10} {:>20} {:9} {:6} {:6} {:<10}{:15} F", 8, width, width,
                  dim == 3 ? width : 1, count, count, "0.0000000000000E+00", 0, 0, 1, "X", "  1.0000000E+00");
  line.resize(header_length, ' ');
  return line;
}

}  // namespace

void NekRe2Bytes::begin(int num_elems, int dim) {
  out_ = fmt::format("#v004{:16}{:3}{:16}{:4} hdr", num_elems, dim, num_elems, 1);
  out_.resize(80, ' ');
  append_little_endian(out_, byte_order_mark);
}

void NekRe2Bytes::put(double number) { append_little_endian(out_, number); }

void NekRe2Bytes::write_record(int elem, int side, const std::array<double, 5>& numbers, const char* word) {
  put(elem + 1), put(side + 1);
  for (const double number : numbers) put(number);
  out_ += fmt::format("{:<8}", word);
}

std::string nek_geometry_field(int order, int dim, const std::vector<int>& elem_nodes,
                               const std::vector<std::array<double, 3>>& positions) {
  std::size_t per_elem = 1;
  for (int axis = 0; axis < dim; ++axis) per_elem *= order + 1;
  const std::size_t count = elem_nodes.size() / per_elem;
  std::string bytes = field_header(order + 1, dim, count);
  bytes.reserve(bytes.size() + 4 * (1 + count) + 8 * dim * elem_nodes.size());
  append_little_endian(bytes, byte_order_mark);
  for (std::size_t elem = 0; elem < count; ++elem) append_little_endian(bytes, static_cast<int>(elem + 1));
  for (std::size_t first = 0; first < elem_nodes.size(); first += per_elem)
    for (int axis = 0; axis < dim; ++axis)
      for (std::size_t k = 0; k < per_elem; ++k) append_little_endian(bytes, positions[elem_nodes[first + k]][axis]);
  return bytes;
}

}  // namespace quadrille::exports
