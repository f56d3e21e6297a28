#pragma once
// An edge of a hexahedral block as OpenFOAM's blockMesh divides it: points of a spline, walked by the length of the
// polygon through them, and the shares of that length that the cells have.

#include <vector>

#include "export/skeleton.hpp"

namespace quadrille::exports {

struct DividedEdge {
  std::vector<Vec2> vertices;  ///< ends of the cells, one more than there are cells
  std::vector<double> shares;  ///< of each cell, of a sum 1
  std::vector<Vec2> inner;     ///< points of the spline between the ends, the inner vertices among them
  bool is_straight = false;    ///< within 1e-10 of its length: no spline is needed

  int num_cells() const { return static_cast<int>(shares.size()); }
  /// By vertex: the shares before it, as blockMesh adds them up.
  std::vector<double> weights() const;
  DividedEdge reversed() const;
};

/// The edge along sides of elements that follow each other.
DividedEdge divided_edge(const QuadMesh& mesh, const std::vector<SkeletonEdge>& sides);

/// Where blockMesh puts the points of a block whose edges in i direction at j = 0 and j = num_j are `bottom` and `top`,
/// those in j direction at i = 0 and i = num_i `left` and `right`; i fastest. A mean of the straight-sided points on
/// the edges, plus what the splines differ from them, each with weights of its own. Source: OpenFOAM,
/// block::createPoints, in the plane.
std::vector<Vec2> block_mesh_points(const DividedEdge& bottom, const DividedEdge& right, const DividedEdge& top,
                                    const DividedEdge& left);

}  // namespace quadrille::exports
