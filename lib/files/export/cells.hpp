#pragma once
// Elements of quads and of hexahedra by the same names, for writers of both. Sides of elements are the edges of quads
// and the faces of hexahedra (hex_face_corners). An element of order N has (N + 1)^dimension nodes, the first
// coordinate fastest, a side of a hexahedron (N + 1)^2 from its first corner to the second first.

#include <array>
#include <type_traits>
#include <vector>

#include "export/groups.hpp"
#include "export/hex_numbering.hpp"
#include "model/hex_mesh.hpp"
#include "model/quad_mesh.hpp"

namespace quadrille::exports {

template <typename Mesh>
inline constexpr int mesh_dimension = std::is_same_v<Mesh, HexMesh> ? 3 : 2;

inline int block_of(const QuadMesh& mesh, int elem) { return mesh.elem_block[elem]; }
inline int block_of(const HexMesh& mesh, int elem) { return mesh.quad_block[elem % mesh.num_quads]; }

template <typename Mesh>
const int* element_nodes(const Mesh& mesh, int elem) {
  return &mesh.elem_nodes[static_cast<std::size_t>(elem) * mesh.nodes_per_elem()];
}

/// Corners counter-clockwise, of hexahedra in the order of hex_corner_indices; those of quads are counted modulo 4.
inline int corner_node(const QuadMesh& mesh, int elem, int corner) { return side_start(mesh, elem, corner % 4); }
inline int corner_node(const HexMesh& mesh, int elem, int corner) {
  return element_nodes(mesh, elem)[hex_corner_node(mesh.order, corner)];
}

/// The corners of a side: of a quad counter-clockwise, of a hexahedron counter-clockwise seen from outside.
inline std::array<int, 2> side_corners(const QuadMesh&, int side) { return {side, (side + 1) % 4}; }
inline std::array<int, 4> side_corners(const HexMesh&, int side) { return hex_face_corners[side]; }

/// The nodes of a side of an element.
inline std::vector<int> side_nodes(const HexMesh& mesh, int elem, int side) { return face_nodes(mesh, elem, side); }

/// How many coordinates of a node of a tensor of (order + 1)^dimension nodes are not at an end.
inline int inner_coordinates(int order, int dimension, int local) {
  int count = 0;
  for (int c = 0; c < dimension; ++c, local /= order + 1) {
    const int index = local % (order + 1);
    count += index > 0 && index < order ? 1 : 0;
  }
  return count;
}

/// The nodes of a line as most formats have them: the ends, then the others.
inline std::vector<int> ends_first(int order) {
  std::vector<int> nodes{0, order};
  for (int k = 1; k < order; ++k) nodes.push_back(k);
  return nodes;
}

/// A side of an element with a name: its boundary or, after those, its interface.
struct GroupSide {
  int elem = 0, side = 0, group = 0;
  bool is_interface = false;  ///< it lies inside the mesh, also where its group is a boundary of the same name
};

/// The boundary in the order of the loops, then the interfaces, each edge once. The numbering is that of hexahedra
/// only.
inline std::vector<GroupSide> group_sides(const QuadMesh& mesh, const Groups& groups, const EdgeNumbering& = {}) {
  std::vector<GroupSide> sides;
  for (const QuadBoundaryEdge& e : mesh.boundary_edges)
    sides.push_back({e.elem, e.side, groups.curve2boundary[e.curve], false});
  for (const QuadBoundaryEdge& e : interface_edges_once(mesh))
    sides.push_back({e.elem, e.side, groups.curve2boundary[e.curve], true});
  return sides;
}

/// Group by group, faces of interfaces once. `numbering` of the mesh, with edges in any direction; without it errors
/// are those of number_parts.
inline std::vector<GroupSide> group_sides(const HexMesh& mesh, const Groups& groups, const HexNumbering& numbering) {
  std::vector<GroupSide> sides;
  for (std::size_t g = 0; g < mesh.face_groups.size(); ++g)
    for (const GroupFace at : faces_once(mesh.face_groups[g], numbering))
      sides.push_back({at.elem, at.face, groups.curve2boundary[g], mesh.face_groups[g].is_interface});
  return sides;
}

inline std::vector<GroupSide> group_sides(const HexMesh& mesh, const Groups& groups) {
  return group_sides(mesh, groups, number_parts(mesh));
}

/// The same by group.
template <typename Mesh>
std::vector<std::vector<GroupSide>> sides_by_group(const Mesh& mesh, const Groups& groups) {
  std::vector<std::vector<GroupSide>> sides(groups.num_boundaries() + groups.num_interfaces());
  for (const GroupSide& at : group_sides(mesh, groups)) sides[at.group].push_back(at);
  return sides;
}

/// The elements of each region.
template <typename Mesh>
std::vector<std::vector<int>> elements_by_region(const Mesh& mesh, const Groups& groups) {
  std::vector<std::vector<int>> elems(groups.num_regions());
  for (int elem = 0; elem < mesh.num_elems(); ++elem) elems[groups.block2region[block_of(mesh, elem)]].push_back(elem);
  return elems;
}

}  // namespace quadrille::exports
