#pragma once
// A mesh to be relaxed: its movable vertices, the nodes that follow them, and the energy to minimise.

#include <vector>

#include "refine/boundary_slide.hpp"
#include "refine/node_follow.hpp"
#include "refine/shape_energy.hpp"

namespace quadrille::refine {

/// The data that do not change during the relaxation.
struct RelaxProblem {
  /// `frozen_elems` by element: keeps all nodes; empty: none does.
  RelaxProblem(const QuadMesh& mesh, const std::vector<bool>& frozen_elems);
  RelaxProblem(const RelaxProblem&) = delete;
  RelaxProblem& operator=(const RelaxProblem&) = delete;

  const QuadMesh start;  ///< the mesh before; the others refer to it
  const BoundarySlide boundary;
  const NodeFollow follow;
  const ShapeEnergy energy;
  std::vector<bool> is_fixed;  ///< by vertex

  int num_vertices() const { return follow.num_vertices(); }
  /// Sum over all elements, for these nodes; infinite if det J is not positive.
  double total_energy(const std::vector<Vec2>& nodes) const;
};

}  // namespace quadrille::refine
