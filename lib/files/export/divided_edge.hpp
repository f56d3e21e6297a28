#pragma once
// An edge of a hexahedral block as OpenFOAM's blockMesh divides it: points of a spline, parametrized by the length of
// the polygon through them, and the fraction of that length for each cell.

#include <vector>

#include "export/skeleton.hpp"

namespace quadrille::exports {

struct DividedEdge {
  std::vector<Vec2> vertices;     ///< ends of the cells, one more than there are cells
  std::vector<double> fractions;  ///< length fraction of each cell; the sum is 1
  std::vector<Vec2> inner;        ///< points of the spline between the ends, the inner vertices among them
  bool is_straight = false;       ///< within 1e-10 of its length: no spline is needed

  int num_cells() const { return static_cast<int>(fractions.size()); }
  /// By vertex: the sum of the fractions before it, added up as blockMesh does.
  std::vector<double> weights() const;
  DividedEdge reversed() const;
};

/// The edge along consecutive sides of elements.
DividedEdge divided_edge(const QuadMesh& mesh, const std::vector<SkeletonEdge>& sides);

/// The points that blockMesh computes in a block whose edges in i direction at j = 0 and j = num_j are `bottom` and
/// `top`, those in j direction at i = 0 and i = num_i `left` and `right`; i fastest. Each is a mean of points on the
/// straight edges plus a mean deviation of the splines from them, with separate weights. Source: OpenFOAM,
/// block::createPoints, in the plane.
std::vector<Vec2> block_mesh_points(const DividedEdge& bottom, const DividedEdge& right, const DividedEdge& top,
                                    const DividedEdge& left);

}  // namespace quadrille::exports
