#pragma once
// Elements of equal length along the curves of a boundary (--count NAME=N,even): the k-th of n + 1 vertices of a curve
// of length L is at k L / n from its start, that of a smooth closed curve too. So meshes on both sides of a circle on
// which one slides have their nodes in the same places whenever it has turned by a whole number of elements.

#include <optional>
#include <vector>

#include "base/report.hpp"
#include "refine/joint_vertices.hpp"
#include "refine/refine_options.hpp"
#include "refine/relax_problem.hpp"
#include "sizing/make_size_field.hpp"

namespace quadrille::refine {

/// Where the vertices of these curves (by curve; empty: none) have to slide. The vertices nearest to the ends of a
/// curve slide there, those between follow in their order. No value if a curve has no vertex of its own, or one that is
/// fixed elsewhere.
std::optional<std::vector<HeldVertex>> even_vertices(const RelaxProblem& problem, const VertexMoves& moves,
                                                     const std::vector<bool>& is_even);

/// The vertices at the ends of edges along these curves, ascending.
std::vector<int> vertices_on(const RelaxProblem& problem, const std::vector<bool>& is_even);

/// Sets counts.<n>.unevenness for those that are to be even: the greatest difference of the lengths of two elements
/// along one curve, over their mean. Warns (W-QUA-007) if there is any.
void report_even_counts(const QuadMesh& mesh, const std::vector<prescribe::BoundaryCount>& boundaries, Report& report);

/// Throws UsageError if one of these curves has other prescribed lengths too, by `near`, the end gradings or the walls
/// of the options, or if the face is curved.
void require_even_alone(const CadFace& face, const RefineOptions& options, const std::vector<sizing::NearSize>& near);

}  // namespace quadrille::refine
