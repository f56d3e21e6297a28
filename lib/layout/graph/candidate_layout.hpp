#pragma once
// A layout under construction: a separatrix graph together with its topology, its lines from the splines of the graph,
// while every inner arc is a part of one spline, and the corners of its faces, which decide whether it is a layout of
// four-sided blocks.

#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

struct CandidateLayout {
  Provenance provenance;
  Subdivision subdivision;
  std::vector<SeparatrixLine> lines;
  std::vector<int> t_junctions;  ///< as in SeparatrixGraph; empty before the subdivision's nodes are renumbered
  LayoutCertificate certificate;
  int num_built = 0;  ///< subdivisions built from graphs on the way to this layout; operations on one build none

  const ArcGraph& graph() const { return subdivision.graph(); }
};

/// Builds the subdivision: once for each candidate. `num_built`: how many were built before, for the same layout.
inline CandidateLayout candidate_layout(SeparatrixGraph graph, int num_built = 0) {
  CandidateLayout layout;
  layout.num_built = num_built + 1;
  layout.provenance = std::move(graph.provenance);
  layout.lines = std::move(graph.lines);
  layout.t_junctions = std::move(graph.t_junctions);
  layout.certificate = std::move(graph.certificate);
  layout.subdivision = Subdivision(std::move(static_cast<ArcGraph&>(graph)));
  return layout;
}

inline SeparatrixGraph separatrix_graph(CandidateLayout layout) {
  return {layout.subdivision.release(), std::move(layout.provenance), std::move(layout.lines),
          std::move(layout.t_junctions), std::move(layout.certificate)};
}

/// The kind of the line of each spline; traced where none uses it.
std::vector<LineKind> spline_kinds(const ArcGraph& graph, const std::vector<SeparatrixLine>& lines);

/// For each spline a line for each run of arcs, of the kind that `kinds` has for the spline.
std::vector<SeparatrixLine> lines_of_arcs(const ArcGraph& graph, const std::vector<LineKind>& kinds);

/// Sets the lines of a layout whose arcs changed, and removes splines that no arc uses. `kinds`: of its splines before
/// the change; those that were added are of the kind `added`.
void rebuild_lines(CandidateLayout& layout, std::vector<LineKind> kinds, LineKind added);

/// The mean of the middles of a face's arcs, file coordinates: a position for messages.
Vec2 middle_of_face(const Subdivision& subdivision, int face);

/// The faces that are no quadrilaterals: their number of sides or of corners is not four.
std::vector<int> faces_without_four_corners(const Subdivision& subdivision);

/// Throws ComputeError unless every face has four corners and the graph has no more parts than regions; the message
/// states how many faces violate this and the position of the first. Returns the number of faces.
int require_four_corners(const Subdivision& subdivision);

/// Whether the curves at a node start in the counter-clockwise order of the topology. Operations of
/// graph/subdivision.hpp do not check this.
bool is_drawn_in_order(const Subdivision& subdivision, int node);

/// Throws ComputeError with a position unless is_drawn_in_order holds at every node: whoever reads the graph from a
/// file has only its curves, and would find other faces.
void require_drawn_in_order(const Subdivision& subdivision);

/// Number of faces for each number of corners, ascending.
std::vector<FaceCount> face_valence_histogram(const Subdivision& subdivision);

}  // namespace quadrille::graph
