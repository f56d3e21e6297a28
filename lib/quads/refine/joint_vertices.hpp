#pragma once
// After vertices have moved freely along the boundary, a vertex is put at each joint between curves of different names:
// those that have to slide least. So every curve ends at a vertex, and need not keep the vertices that it had there.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "refine/relax_problem.hpp"

namespace quadrille::refine {

/// A vertex that is put at a position on its loop and stays there.
struct HeldVertex {
  int vertex = 0;
  double slide = 0;  ///< along its loop from where it is, a length
};

/// The vertex for each joint that vertices may slide off (BoundarySlide::free_joints) and where none is fixed. The sum
/// of squared slides is least among all choices that keep the order of vertices around the loop, and that leave between
/// successive joints the edges that it takes to lie within `tolerance`, a length, of the curves. O(j n) for j joints
/// and n vertices of a loop. No value if a loop has no such choice.
std::optional<std::vector<HeldVertex>> vertices_at_joints(const RelaxProblem& problem, const VertexMoves& moves,
                                                          double tolerance);

/// The joints between curves of different names, interfaces apart, where no element ends: each is inside an edge, which
/// has the name of one of them. Numbers of the curves that begin there, ascending.
std::vector<int> joints_inside_edges(const QuadMesh& mesh);

/// Warns of these joints, with the place of the first.
void warn_of_joints(const QuadMesh& mesh, Report& report);

}  // namespace quadrille::refine
