#pragma once
// Triangles of order P on a curved face: nodes on the surface, exact on the boundary curves.

#include <array>
#include <vector>

#include "chart/space_length.hpp"
#include "model/space_face.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::chart {

struct SurfaceMesh {
  /// Straight triangles: topology, boundary edges with the parameters of the curves in space, and an approximate image.
  TriMesh plane;
  int order = 1;              ///< P
  std::vector<Vec3> nodes;    ///< (P+1)(P+2)/2 per element, as spectral/tri_map
  std::vector<Vec3> normals;  ///< of the face, unit, at the nodes
  std::vector<Vec2> uv;       ///< at the nodes
  std::vector<Vec2> image;    ///< of the nodes in the chart
  std::vector<double> scale;  ///< at the nodes: s, the logarithm of lengths in the chart over those in space

  int num_elems() const { return plane.num_elems(); }
  int nodes_per_elem() const { return (order + 1) * (order + 2) / 2; }
};

/// The derivative of the image at the start, or at the end, of a boundary edge with respect to the part of its length.
Vec2 image_slope(const SurfaceMesh& mesh, const BoundaryEdge& edge, bool at_end);

/// Of each element: the least area at a node, signed by the normal, over that of the straight
/// triangle; -infinity where one is no number. Where the map turns over it is negative.
std::vector<double> least_area_ratios(const SurfaceMesh& mesh);

/// The unit normal of the face; zero where the parametrisation of the surface degenerates.
Vec3 face_normal(const SpaceFace& face, Vec2 uv);

/// Parameters of a corner of a triangle. At a pole, a side of the domain that is one point, all values of the parameter
/// along the side are right, so that none counts.
struct CornerParameters {
  Vec2 uv;
  bool has_u = true, has_v = true;
};

CornerParameters corner_parameters(const SpaceFace& face, Vec2 uv);

/// Makes nodes of `order` for the triangles of `plane`, a mesh of the image of `last`: vertices are lifted by `last`,
/// inner nodes lie on the surface nearest to the blended triangle. `lengths`: of the curves. Throws ComputeError,
/// with the place, where no point of the surface is near.
SurfaceMesh lifted_mesh(const SpaceFace& face, const std::vector<SpaceLength>& lengths, const SurfaceMesh& last,
                        TriMesh plane, int order);

}  // namespace quadrille::chart
