#pragma once
// Vertices for the joints between curves of different names: those that are nearest when all vertices have moved
// freely. So names end at vertices, and no vertex has to stay where the mesh before had it.

#include <optional>
#include <vector>

#include "refine/relax_problem.hpp"

namespace quadrille::refine {

struct JointVertex {
  int vertex = 0;
  double slide = 0;  ///< along its loop from where it is to its joint, a length
};

/// For each joint that vertices may slide off (BoundarySlide::free_joints) the free vertex that is put there, unless a
/// fixed one is there: the nearest ones, in their order around the loop. No value if a loop has too few vertices.
std::optional<std::vector<JointVertex>> vertices_at_joints(const RelaxProblem& problem, const VertexMoves& moves);

}  // namespace quadrille::refine
