#pragma once
// Points, curves and surfaces of a quad mesh, as solver formats define them: surfaces are the blocks, curves are
// the pieces of the boundary and of the lines between blocks, points are where curves meet.
//
// Rebuilt from the elements alone. A boundary curve lies on one CAD curve and bounds one block; it is directed with the
// domain on its left. An interface of the face lies on the CAD curve of its lower number, and is directed as this is. A
// closed curve starts and ends in the same point.

#include <array>
#include <vector>

#include "model/quad_mesh.hpp"

namespace quadrille::exports {

struct SkeletonEdge {
  int elem = 0, side = 0;
};

struct SkeletonCurve {
  int cad_curve = -1;                 ///< -1: only a line between blocks
  int from = 0, to = 0;               ///< points (index into Skeleton::points)
  std::array<int, 2> blocks{-1, -1};  ///< on the left and on the right of the curve; -1 outside
  std::vector<SkeletonEdge> edges;    ///< in the order and direction of the curve, as sides of elements on the left

  bool is_boundary() const { return blocks[1] < 0; }
};

struct Skeleton {
  std::vector<int> points;  ///< mesh nodes
  std::vector<SkeletonCurve> curves;
};

/// Of a conforming mesh; linear in the number of its elements.
Skeleton mesh_skeleton(const QuadMesh& mesh);

}  // namespace quadrille::exports
