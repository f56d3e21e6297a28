#pragma once
// Common interface of the discretisations of the Laplace problems: one mesh, prepared once, and solutions for
// successive order maps on it.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "base/progress.hpp"
#include "base/stopwatch.hpp"
#include "mesh/elimination_tree.hpp"
#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

/// A mesh with all derived data that do not depend on the order map.
struct MeshContext {
  explicit MeshContext(const TriMesh& mesh);  ///< `mesh` must outlive the context

  const TriMesh* mesh;
  mesh::TriTopology topology;
  std::vector<spectral::TriMap> maps;
  mesh::EliminationTree tree;
  Progress* progress = nullptr;  ///< of the computations on this mesh, as long as it exists

  /// "element 7 near (0.5, 0.25)", in the user's coordinates.
  std::string describe(int elem) const;
};

/// The solution of both Laplace problems for one order map.
struct Solution {
  std::vector<Eigen::MatrixXd> elem_coefs;  ///< orthogonal basis of the element's order, columns u, v
  int num_unknowns = 0;                     ///< of the condensed system
  double residual = 0;                      ///< of the condensed system, |rhs - K x| / |rhs|
  std::vector<Lap> laps;                    ///< time of each phase of the solution
};

/// A method that solves both Laplace problems on one mesh.
class Discretization {
 public:
  virtual ~Discretization() = default;
  /// Solves with order elem_order[e] on element e. Throws ComputeError if the factorisation breaks down.
  virtual Solution solve(const std::vector<int>& elem_order) = 0;
  /// Size of the condensed system for this order map.
  virtual int num_unknowns(const std::vector<int>& elem_order) const = 0;
};

}  // namespace quadrille::galerkin
