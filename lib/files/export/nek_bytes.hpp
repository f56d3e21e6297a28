#pragma once
// What Nek5000's binary files of quads and of hexahedra have in common. Private to nek_re2*.

#include <array>
#include <string>
#include <vector>

namespace quadrille::exports {

/// The bytes of an .re2 file, version 4, little endian, numbers in double precision.
class NekRe2Bytes {
 protected:
  /// The header of a mesh in 2 or 3 dimensions.
  void begin(int num_elems, int dim);
  void put(double number);
  /// Element and side, which count from 0 here and from 1 in the file, five numbers, a word of eight letters.
  void write_record(int elem, int side, const std::array<double, 5>& numbers, const char* word);

  std::string out_;
};

/// The geometry at Gauss-Lobatto-Legendre points, which Nek5000 uses as the positions of its own points: a field file.
/// `elem_nodes`: the (order + 1)^dim nodes of each element; `positions`: by node, of which `dim` coordinates are
/// written.
std::string nek_geometry_field(int order, int dim, const std::vector<int>& elem_nodes,
                               const std::vector<std::array<double, 3>>& positions);

}  // namespace quadrille::exports
