#pragma once
// Vertices, edges and faces of a hexahedral mesh, numbered in the order in which a loop over the elements meets them:
// edges in the order of hex_edge_corners, faces bottom, sides 0 to 3, top, which is the order of MFEM and of Nektar++.
//
// Index base 0. From order 2 on, edges and faces are distinguished by their inner nodes, so that two between the same
// vertices stay separate.

#include <array>
#include <vector>

#include "export/edge_numbering.hpp"
#include "model/hex_mesh.hpp"

namespace quadrille::exports {

// Corners in the order of VTK, Gmsh, MFEM, Nek5000 and Abaqus: the bottom counter-clockwise seen from above, then the
// top.

inline constexpr std::array<std::array<int, 3>, 8> hex_corner_indices{
    {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}}};

/// The corners of the edges, each in the direction of its coordinate: bottom, top, then the upright ones.
inline constexpr std::array<std::array<int, 2>, 12> hex_edge_corners{
    {{0, 1}, {1, 2}, {3, 2}, {0, 3}, {4, 5}, {5, 6}, {7, 6}, {4, 7}, {0, 4}, {1, 5}, {2, 6}, {3, 7}}};

/// The corners of the faces of HexMesh round the face, its outside on the reader's side. The nodes of a face run from
/// the first corner to the second first, then towards the fourth.
inline constexpr std::array<std::array<int, 4>, 6> hex_face_corners{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {2, 3, 7, 6}, {3, 0, 4, 7}, {3, 2, 1, 0}, {4, 5, 6, 7}}};

/// The same from the corner where both coordinates begin, the first of them first.
inline constexpr std::array<std::array<int, 4>, 6> directed_hex_face_corners{
    {{0, 1, 5, 4}, {1, 2, 6, 5}, {3, 2, 6, 7}, {0, 3, 7, 4}, {0, 1, 2, 3}, {4, 5, 6, 7}}};

/// Faces in the order in which they are numbered.
inline constexpr std::array<int, 6> hex_face_order{4, 0, 1, 2, 3, 5};

/// Where a corner stands among the nodes of an element.
constexpr int hex_corner_node(int order, int corner) {
  const auto [i, j, k] = hex_corner_indices[corner];
  return order * ((k * (order + 1) + j) * (order + 1) + i);
}

struct NumberedHexFace {
  int elem = 0, face = 0;                ///< the element of lower number
  int other_elem = -1, other_face = -1;  ///< -1 on the boundary
};

struct HexNumbering : EdgeNumbering {
  std::vector<int> elem2faces;  ///< 6 per element, by the face's number in HexMesh
  std::vector<NumberedHexFace> faces;

  int num_faces() const { return static_cast<int>(faces.size()); }
  int vertex(int elem, int corner) const { return elem2verts[8 * elem + corner]; }
  int face(int elem, int face) const { return elem2faces[6 * elem + face]; }
};

HexNumbering number_parts(const HexMesh& mesh);

/// Mesh nodes of an edge of an element in the direction of hex_edge_corners, or of an edge in its own direction, both
/// ends included.
std::vector<int> edge_nodes(const HexMesh& mesh, int elem, int edge);
std::vector<int> edge_nodes(const HexMesh& mesh, const NumberedEdge& edge);

/// Where the order + 1 nodes of an edge stand among those of its element, from its first corner to the second.
std::vector<int> local_edge_nodes(int order, const std::array<int, 2>& corners);

/// Where the (order + 1)^2 nodes of a face stand among those of its element, from its first corner to the second first,
/// then towards the fourth.
std::vector<int> local_face_nodes(int order, const std::array<int, 4>& corners);

/// Mesh nodes of a face of an element in the order of hex_face_corners, or from other corners on.
std::vector<int> face_nodes(const HexMesh& mesh, int elem, int face);
std::vector<int> face_nodes(const HexMesh& mesh, int elem, const std::array<int, 4>& corners);

/// The same elements, each turned about xi3 so that the sides of every element that are parallel run in one direction,
/// as turned_along_chords makes them in each layer.
HexMesh turned_along_chords(const HexMesh& mesh);

/// number_parts of a mesh that is turned along its chords, with edges in the direction of hex_edge_corners, which need
/// not begin at the vertex of lower number.
HexNumbering number_directed_parts(const HexMesh& turned);

/// Throws ComputeError with the position if two edges, or two faces, join the same vertices, which `reader` could not
/// distinguish.
void require_known_by_vertices(const HexMesh& mesh, const HexNumbering& numbering, const char* reader);

/// A face of an element that belongs to a group.
struct GroupFace {
  int elem = 0, face = 0;
};

/// The faces of a group in its order, those of an interface once: from the element of lower number.
std::vector<GroupFace> faces_once(const HexFaceGroup& group, const HexNumbering& numbering);

}  // namespace quadrille::exports
