#include "export/nek_field.hpp"

#include <fmt/format.h>

#include "export/little_endian.hpp"

namespace quadrille::exports {
namespace {

constexpr std::size_t header_length = 132;
constexpr float byte_order_mark = 6.54321F;

/// Word size, points in each direction, elements here and in all, time, step, file and number of files, contents,
/// thermodynamic pressure, no pressure on the velocity's points.
std::string header(const QuadMesh& mesh) {
  const int width = mesh.order + 1, count = mesh.num_elems();
  std::string line = fmt::format("#std {:1} {:2} {:2} {:2} {:10} {:10} {:>20} {:9} {:6} {:6} {:<10}{:15} F", 8, width,
                                 width, 1, count, count, "0.0000000000000E+00", 0, 0, 1, "X", "  1.0000000E+00");
  line.resize(header_length, ' ');
  return line;
}

}  // namespace

std::string nek_geometry_field(const QuadMesh& mesh, const Frame& frame) {
  std::string bytes = header(mesh);
  const std::size_t num_values = 2 * mesh.elem_nodes.size();
  bytes.reserve(bytes.size() + 4 * (1 + mesh.elem_block.size()) + 8 * num_values);
  append_little_endian(bytes, byte_order_mark);
  for (int elem = 0; elem < mesh.num_elems(); ++elem) append_little_endian(bytes, elem + 1);
  const int count = mesh.nodes_per_elem();
  for (int elem = 0; elem < mesh.num_elems(); ++elem)
    for (int axis = 0; axis < 2; ++axis)
      for (int k = 0; k < count; ++k)
        append_little_endian(bytes, frame.at(mesh.nodes[mesh.elem_nodes[elem * count + k]])[axis]);
  return bytes;
}

}  // namespace quadrille::exports
