#pragma once
// A layout under construction: a separatrix graph together with its topology.

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

}  // namespace quadrille::graph
