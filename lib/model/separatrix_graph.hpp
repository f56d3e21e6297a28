#pragma once
// The planar graph of separatrices and boundary (formats/separatrix-graph.md, x.sep.json).

#include <string>
#include <vector>

#include "model/arc_graph.hpp"
#include "model/provenance.hpp"

namespace quadrille {

/// How a separatrix came to be, for people and pictures: origin and end node, and its arcs from one to the other.
struct SeparatrixLine {
  int origin = -1;
  int end = -1;
  std::string kind;  ///< "traced", "merged", "cut"
  std::vector<int> arcs;
};

/// So many faces of the graph have so many corners: quarter turns of the cross, not degrees in space. A degenerate
/// corner counts for two.
struct FaceCount {
  int corners = 4;
  int faces = 0;
};

/// What was counted on a graph, and the method that made it.
struct LayoutCertificate {
  std::string method;  ///< "traced", "quantized" or "t-mesh"; empty: the graph comes without a certificate
  std::string reason;  ///< a sentence for people: why not "traced", where that was tried first; else empty
  int index_sum = 0;   ///< sum (4 - V) over inner and sum (2 - V) over boundary nodes: 4 chi
  std::vector<FaceCount> face_valence_histogram;  ///< by rising corners
  int t_junctions = 0;                            ///< 0: conforming
  int merged_lines = 0;                           ///< pairs of separatrices that met and became one
  int collapsed_chords = 0;                       ///< thin chords of blocks that were collapsed
  int shortened_spirals = 0;             ///< lines that end at a node which they pass, instead of one turn later
  double largest_deviation_degrees = 0;  ///< largest angle between a line and the field
};

struct SeparatrixGraph : ArcGraph {
  Provenance provenance;
  std::vector<SeparatrixLine> lines;
  std::vector<int> t_junctions;  ///< nodes where an arc ends on the side of a block; empty for a conforming layout
  LayoutCertificate certificate;
};

}  // namespace quadrille
