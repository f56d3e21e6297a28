#pragma once
// Boundary coefficients of a pair of functions given on the exact curves.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <vector>

#include "curve/arc_length.hpp"
#include "galerkin/dof_map.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille {

/// The pair's value at parameter t of a boundary curve.
using BoundaryData = std::function<Vec2(int curve, double t)>;

/// Values of the boundary dofs for any order map of one mesh. Exact at vertices; on an edge the projection in the norm
/// of the derivative along it, which is diagonal in the edge modes: orders share what has been computed once. The point
/// at fraction s of an edge lies at fraction s of the curve's arc length, as the element's own geometry nodes do.
class DirichletData {
 public:
  /// `mesh` must outlive this.
  DirichletData(const TriMesh& mesh, BoundaryData data);
  /// Values of the dofs [num_unknowns, num_dofs), columns u, v.
  Eigen::MatrixX2d values(const TriTopology& topology, const DofMap& map);

 private:
  /// Projection of the data on one edge, walked as its element does.
  struct Edge {
    int order = 0;  ///< of the projection; 0: not made yet
    Eigen::RowVector2d first, last;
    Eigen::MatrixX2d coefs;  ///< of the edge modes of degree 2..order
  };
  void project(const BoundaryEdge& boundary_edge, int order, Edge& edge);

  const TriMesh* mesh_;
  BoundaryData data_;
  std::vector<std::unique_ptr<ArcLength>> arc_lengths_;  ///< by curve, made on first use
  std::vector<Edge> edges_;                              ///< by boundary edge
};

}  // namespace quadrille
