#pragma once
// A layout while it is made: a separatrix graph that knows its topology.

#include <vector>

#include "graph/subdivision.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::graph {

struct CandidateLayout {
  Provenance provenance;
  Subdivision subdivision;
  std::vector<SeparatrixLine> lines;
  std::vector<int> t_junctions;  ///< as in SeparatrixGraph; empty before the subdivision's nodes are numbered anew
  LayoutCertificate certificate;

  const ArcGraph& graph() const { return subdivision.graph(); }
};

/// Builds the subdivision: once for each candidate.
inline CandidateLayout candidate_layout(SeparatrixGraph graph) {
  CandidateLayout layout;
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
