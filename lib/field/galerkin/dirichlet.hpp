#pragma once
// Coefficients of boundary dofs for functions prescribed on the exact curves.

#include <Eigen/Dense>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include "curve/chain.hpp"
#include "galerkin/condensed_system.hpp"
#include "model/tri_mesh.hpp"

namespace quadrille::galerkin {

/// The value (u, v) at parameter t of a boundary curve.
using BoundaryData = std::function<Vec2(int curve, double t)>;
/// Writes the values of a scalar function at some parameters t of a boundary curve.
using BoundaryScalars = std::function<void(int curve, std::span<const double> t, double* values)>;

/// The sample points of the data: Gauss points along each boundary edge. The point at fraction s of an edge lies at
/// fraction s of the curve's arc length, as the geometry nodes of the element do. Computed once for all data on a mesh.
class BoundaryPoints {
 public:
  /// `mesh` must outlive this.
  explicit BoundaryPoints(const TriMesh& mesh);
  /// Curve parameters of the points for projections of `order` on boundary edge b, in the element's direction.
  const std::vector<double>& parameters(int b, int order);
  const TriMesh& mesh() const { return *mesh_; }

 private:
  struct Edge {
    int order = 0;
    std::vector<double> parameters;
  };
  const TriMesh* mesh_;
  std::vector<std::unique_ptr<curve::ArcLength>> arc_lengths_;  ///< by curve, made on first use
  std::vector<Edge> edges_;                                     ///< by boundary edge
};

/// Values of the boundary dofs for any order map of one mesh. Exact at vertices; on an edge, the projection in the norm
/// of the derivative along the edge. It is diagonal in the edge modes, so coefficients are reused for other orders.
class DirichletData {
 public:
  /// `mesh` must outlive this.
  DirichletData(const TriMesh& mesh, BoundaryData data);
  /// `points` may be shared with other data on the same mesh.
  DirichletData(std::shared_ptr<BoundaryPoints> points, BoundaryData data);
  /// One scalar function.
  DirichletData(std::shared_ptr<BoundaryPoints> points, BoundaryScalars data);
  /// Values of the dofs [num_unknowns, num_dofs): columns u, v, or one column for a scalar function.
  Eigen::MatrixXd values(const mesh::TriTopology& topology, const DofMap& map);

 private:
  /// Projection of the data on one edge, in the direction of its element.
  struct Edge {
    int order = 0;  ///< of the projection; 0: not computed yet
    Eigen::RowVectorXd first, last;
    Eigen::MatrixXd coefs;  ///< of the edge modes of degree 2..order
  };
  using Samples = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, Eigen::RowMajor>;  ///< one row per point
  /// Writes num_columns_ values for each t.
  using Sampler = std::function<void(int curve, std::span<const double> t, double* values)>;
  DirichletData(std::shared_ptr<BoundaryPoints> points, int num_columns, Sampler sampler);
  Samples at(int curve, std::span<const double> t) const;
  void sample_ends(int first, int last);
  void project(const std::vector<int>& edges, const std::vector<int>& orders);
  void update_projections(const mesh::TriTopology& topology, const DofMap& map);

  std::shared_ptr<BoundaryPoints> points_;
  int num_columns_;
  Sampler sampler_;
  std::vector<Edge> edges_;  ///< by boundary edge
};

}  // namespace quadrille::galerkin
