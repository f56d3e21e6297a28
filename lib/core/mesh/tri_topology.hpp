#pragma once
// Adjacency of a triangle mesh (index base 0, -1 = none), the maps of its elements, and its mirror image.

#include <array>
#include <vector>

#include "curve/symmetry_lines.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::mesh {

struct TriTopology {
  std::vector<std::array<int, 2>> edge2vertices;        ///< lower vertex first; sorted
  std::vector<std::array<int, 2>> edge2elems;           ///< second is -1 on the boundary
  std::vector<std::array<int, 3>> elem2edges;           ///< by local edge
  std::vector<std::array<int, 3>> elem2neighbors;       ///< by local edge
  std::vector<std::array<int, 3>> elem2neighbor_edges;  ///< the neighbour's local edge
  std::vector<std::array<int, 3>> elem2boundary_edge;   ///< index into mesh.boundary_edges or -1
};

/// Throws FormatError if three elements share an edge, if two have the same direction along an edge, or if the boundary
/// edges of the mesh are not exactly the edges with one element.
TriTopology tri_topology(const TriMesh& mesh);

/// One map per element: affine, or of the mesh's order for the elements listed in curved_elems.
std::vector<spectral::TriMap> tri_maps(const TriMesh& mesh);

/// Smallest angle of any element with straight edges between its vertices, radians.
double least_angle(const TriMesh& mesh);

/// `half`: of one region; `face`: mirrored_face() of its face at `line`. Element e of the half is element e of the
/// whole, and its mirror image is element e + half.num_elems(), with its second and third vertex exchanged. The
/// vertices on the line belong to both.
TriMesh mirrored_mesh(const TriMesh& half, const curve::MirroredFace& face, const curve::SymmetryLine& line);

}  // namespace quadrille::mesh
