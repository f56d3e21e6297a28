#pragma once
// Triangles that are known by the lengths of their sides (Fisher, Springborn, Bobenko, Schröder, 2007): edges are
// flipped as if the two triangles beside them were laid into a plane, which changes no length on the surface. So
// slivers, and triangles that are turned over in space because they are too coarse, become Delaunay triangles without a
// look at their shapes in space.

#include <array>
#include <vector>

#include "chart/space_length.hpp"
#include "model/space_face.hpp"

namespace quadrille::chart {

struct IntrinsicTriangle {
  std::array<int, 3> vertices{};
  std::array<Vec2, 3> uv;           ///< parameters of the corners, continuous inside the triangle
  std::array<double, 3> lengths{};  ///< of side k, from corner k to k + 1
  std::array<int, 3> across{};      ///< of side k: 3 t + j, side j of triangle t; -1 - b: boundary edge b
};

struct IntrinsicTriangles {
  std::vector<Vec3> vertices;  ///< on the surface
  std::vector<Vec3> normals;   ///< of the face at the vertices; 0 where the parametrisation degenerates
  std::vector<IntrinsicTriangle> triangles;
  std::vector<FineBoundaryEdge> boundary_edges;
};

/// The fine triangles of the face, with sides halved where they are long for the face or its normal turns far along
/// them, then Delaunay, by flips that leave all lengths on the triangles as they are. `lengths`: of the curves. Throws
/// ComputeError, with the place, where an edge has no length.
IntrinsicTriangles delaunay_triangles(const SpaceFace& face, const std::vector<SpaceLength>& lengths);

}  // namespace quadrille::chart
