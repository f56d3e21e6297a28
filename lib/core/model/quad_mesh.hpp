#pragma once
// The refined curved quad mesh (formats/quad-mesh.md, x.quad.h5).
//
// Reference square [-1,1]^2; element nodes at the tensor Gauss-Lobatto-Legendre points, xi1 fastest: node (i, j) at
// elem_nodes[e * (N+1)^2 + j * (N+1) + i]. Corners counter-clockwise: (0,0), (N,0), (N,N), (0,N). Side k runs from
// corner k to corner k+1 (mod 4). Elements share their nodes, so a conforming mesh is so bit for bit.

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "base/vec2.hpp"
#include "base/vec3.hpp"
#include "model/cad_face.hpp"
#include "model/provenance.hpp"

namespace quadrille {

struct QuadBoundaryEdge {
  int elem = 0;
  int side = 0;
  int curve = 0;  ///< CAD curve of the edge; if the edge passes a joint, the curve at its middle
};

struct QuadMesh {
  Provenance provenance;
  CadFace face;
  int order = 1;  ///< shape order N
  std::vector<Vec2> nodes;
  /// Of a curved face (face.chart): the nodes on the surface, in the coordinates of the CAD file; `nodes` are those in
  /// the chart. Elements are then the polynomials in space, and so are all measures. Empty: the mesh is planar.
  std::vector<Vec3> space_nodes;
  std::vector<int> elem_nodes;
  std::vector<int> elem_block;
  /// Least Bernstein coefficient of det J, in space of the normal component (spectral/quad_map): a proved lower bound.
  std::vector<double> elem_jacobian_bound;
  std::vector<double> elem_scaled_jacobian;  ///< least sampled det J / (|x_xi1| |x_xi2|), in space of the sine
  // Lengths, which the scaled Jacobian does not see (mesh/element_sizes); empty in files before version 1.3.
  std::vector<double> elem_edge_ratio;     ///< longest over shortest side
  std::vector<double> elem_area_jump;      ///< greatest ratio of its area and a neighbour's, either way
  std::vector<double> elem_node_distance;  ///< least distance of neighbours in its grid of nodes, a length
  /// Prescribed edge length at its middle, after --refine a part of it; 0 where wall layers prescribe others. Empty in
  /// files before version 2.1.
  std::vector<double> elem_prescribed_length;
  /// Where a metric is prescribed, the tensor S of determinant 1: edges along the unit vector t have the prescribed
  /// length over |S t|. Empty: lengths do not differ by direction.
  std::vector<SymmetricTensor> elem_prescribed_stretch;
  std::vector<QuadBoundaryEdge> boundary_edges;  ///< sorted along the loops
  /// Edges on interfaces, from both sides: each with the curve of its own region. Sorted as boundary_edges.
  std::vector<QuadBoundaryEdge> interface_edges;
  std::vector<int> open_curves;  ///< ArcGraph::open_curves: their edges are boundary edges
  std::vector<std::string> block_names;
  std::vector<int> unnamed_blocks;  ///< ascending: blocks without a given name; theirs is made from their number
  std::vector<int> block_region;    ///< region of each block; empty: there is one region
  int num_irregular = 0;            ///< inner irregular nodes (V != 4), also of rings around tips
  double least_jacobian_bound = 0;  ///< the least of elem_jacobian_bound
  bool is_valid = true;             ///< every element is proved valid: least_jacobian_bound > 0

  int nodes_per_elem() const { return (order + 1) * (order + 1); }
  int num_elems() const { return static_cast<int>(elem_block.size()); }
  int region_of(int elem) const { return block_region.empty() ? -1 : block_region[elem_block[elem]]; }
  int num_unproved() const {
    return static_cast<int>(
        std::count_if(elem_jacobian_bound.begin(), elem_jacobian_bound.end(), [](double b) { return !(b > 0); }));
  }
};

// The nodes on the sides of elements.

/// Where node k (0 to N) of a side stands among the (N + 1)^2 nodes of its element.
inline int local_side_node(int order, int side, int k) {
  const int width = order + 1;
  const std::array<int, 4> starts{0, order, width * width - 1, width * order}, strides{1, width, -1, -width};
  return starts[side] + k * strides[side];
}

/// Node k (0 to N) of a side of an element.
inline int side_node(const QuadMesh& mesh, int elem, int side, int k) {
  return mesh.elem_nodes[elem * mesh.nodes_per_elem() + local_side_node(mesh.order, side, k)];
}

/// The node at the corner where the side starts.
inline int side_start(const QuadMesh& mesh, int elem, int side) { return side_node(mesh, elem, side, 0); }

/// The N + 1 nodes of a side, both ends included.
inline std::vector<int> side_nodes(const QuadMesh& mesh, int elem, int side) {
  std::vector<int> nodes;
  for (int k = 0; k <= mesh.order; ++k) nodes.push_back(side_node(mesh, elem, side, k));
  return nodes;
}

}  // namespace quadrille
