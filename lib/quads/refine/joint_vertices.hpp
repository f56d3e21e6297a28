#pragma once
// Vertices for the joints between curves of different names, when all vertices have moved freely: those that have to
// slide least. So names end at vertices, and no vertex has to stay where the mesh before had it.

#include <optional>
#include <vector>

#include "refine/relax_problem.hpp"

namespace quadrille::refine {

struct JointVertex {
  int vertex = 0;
  double slide = 0;  ///< along its loop from where it is to its joint, a length
};

/// For each joint that vertices may slide off (BoundarySlide::free_joints) the vertex that is put there, but for those
/// where a fixed one is: of all choices that keep the order around the loop, and between successive ones as many edges
/// as keep within `tolerance` of the curves, the one with the least sum of squared slides. No value if there is none.
std::optional<std::vector<JointVertex>> vertices_at_joints(const RelaxProblem& problem, const VertexMoves& moves,
                                                           double tolerance);

}  // namespace quadrille::refine
