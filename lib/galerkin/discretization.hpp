#pragma once
// What the ways of solving the Laplace problems have in common: a mesh made ready once, and solutions for a sequence of
// order maps on it.

#include <Eigen/Dense>
#include <string>
#include <vector>

#include "base/stopwatch.hpp"
#include "galerkin/elimination_tree.hpp"
#include "mesh/tri_topology.hpp"
#include "model/tri_mesh.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::galerkin {

/// A mesh with all that is derived from it and does not depend on orders.
struct MeshContext {
  explicit MeshContext(const TriMesh& mesh);  ///< `mesh` must outlive the context

  const TriMesh* mesh;
  mesh::TriTopology topology;
  std::vector<spectral::TriMap> maps;
  EliminationTree tree;

  /// "element 7 near (0.5, 0.25)", in the user's coordinates.
  std::string describe(int elem) const;
};

/// Stiffness matrices of the modified basis for changing orders. A curved element's integrals are expensive: they are
/// made for table_order(order), kept, and cut down.
class StiffnessTable {
 public:
  explicit StiffnessTable(const MeshContext& context);  ///< `context` must outlive the table
  /// Different elements may be asked for by different threads.
  Eigen::MatrixXd operator()(int elem, int order);

 private:
  struct Integrals {
    int order = 0;
    Eigen::MatrixXd stiffness;
  };
  const MeshContext* context_;
  std::vector<Integrals> curved_;
};

struct Solution {
  std::vector<Eigen::MatrixXd> elem_coefs;  ///< modified basis of the element's order, columns u, v
  int num_unknowns = 0;                     ///< of the condensed system
  double residual = 0;                      ///< of the condensed system, relative to its right-hand side
  std::vector<Lap> laps;                    ///< where the time went
};

class Discretization {
 public:
  virtual ~Discretization() = default;
  /// Throws ComputeError when the factorisation breaks down.
  virtual Solution solve(const std::vector<int>& elem_order) = 0;
  /// Size of the condensed system for this order map.
  virtual int num_unknowns(const std::vector<int>& elem_order) const = 0;
};

}  // namespace quadrille::galerkin
