#pragma once
// The curved hexahedral mesh that a quad mesh sweeps (formats/hex-mesh.md, x.hex.h5).
//
// Reference cube [-1,1]^3; element nodes at the tensor Gauss-Lobatto-Legendre points, xi1 fastest, then xi2, then xi3:
// node (i, j, k) at elem_nodes[e * (N+1)^3 + (k * (N+1) + j) * (N+1) + i]. (xi1, xi2) are the coordinates of the quad
// that is swept, xi3 runs with the sweep, and det J > 0. Faces 0 to 3 are the sides of the quad (face k on side k),
// 4 is the bottom (xi3 = -1), 5 the top (xi3 = 1). Elements share their nodes, so the mesh conforms bit for bit.
// Elements are sorted by layers: element (quad q, layer l) is l * num_quads + q.

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "base/vec3.hpp"
#include "model/provenance.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille {

/// A rigid motion in space, x -> matrix x + shift, rows of the matrix.
struct SpaceMotion {
  std::array<Vec3, 3> matrix{Vec3{1, 0, 0}, Vec3{0, 1, 0}, Vec3{0, 0, 1}};
  Vec3 shift;
};

/// Faces of the boundary or of interfaces with one name.
struct HexFaceGroup {
  std::string name;
  std::vector<int> elems = {}, faces = {};  ///< element and face (0 to 5) of each; of an interface from both sides
  bool is_interface = false;                ///< between two regions
  /// The group that this one is moved to by `motion`, if the two are periodic: face n to face n. -1: none. Of the two
  /// the first has it.
  int periodic_with = -1;
  SpaceMotion motion = {};
};

struct HexMesh {
  Provenance provenance;
  std::string length_unit;  ///< as CadFace::length_unit
  double diameter = 0;      ///< of the swept body's box, for tolerances
  int order = 1;            ///< shape order N
  int num_quads = 0;        ///< elements of a layer: those of the quad mesh
  std::vector<Vec3> nodes;  ///< in the coordinates of the CAD model
  std::vector<int> elem_nodes;
  std::vector<int> quad_block;    ///< of each quad: the block of the layout
  std::vector<int> block_region;  ///< of each block: an index of region_names
  std::vector<std::string> region_names;
  std::vector<HexFaceGroup> face_groups;
  std::vector<double> elem_jacobian_bound;   ///< a proved lower bound of det J (spectral/hex_map)
  std::vector<double> elem_scaled_jacobian;  ///< least sampled det J / (|x_xi1| |x_xi2| |x_xi3|)
  double least_jacobian_bound = 0;
  bool is_valid = true;  ///< every element is proved valid: least_jacobian_bound > 0

  int nodes_per_elem() const { return (order + 1) * (order + 1) * (order + 1); }
  int num_elems() const { return static_cast<int>(elem_jacobian_bound.size()); }
  int num_layers() const { return num_quads == 0 ? 0 : num_elems() / num_quads; }
  int region_of(int elem) const { return block_region[quad_block[elem % num_quads]]; }
};

/// Where the nodes of a face stand among those of its element: (N+1)^2 of them, the first index fastest, so that the
/// cross product of the two directions points out of the element. The first direction of a side is that of the side of
/// the quad, the second is xi3.
inline std::vector<int> hex_face_nodes(int order, int face) {
  const int width = order + 1, layer = width * width;
  std::vector<int> nodes;
  for (int b = 0; b <= order; ++b)
    for (int a = 0; a <= order; ++a) {
      if (face < 4)
        nodes.push_back(b * layer + local_side_node(order, face, a));
      else
        nodes.push_back(face == 4 ? a * width + b : order * layer + b * width + a);
    }
  return nodes;
}

}  // namespace quadrille
