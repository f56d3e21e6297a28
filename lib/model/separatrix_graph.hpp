#pragma once
// The planar graph of separatrices and boundary (formats/separatrix-graph.md, x.sep.json).
//
// Arcs meet only in nodes. Every arc is a chain of pieces of curves: of the CAD face (curve < face.num_curves()) or of
// `splines` (curve - face.num_curves()). Nodes are all places where something happens to the TOPOLOGY: irregular
// nodes, corners, ends of separatrices on the boundary, crossings. A joint with V = 2 where no separatrix ends is no
// node: it lies inside an arc, between two pieces.

#include <string>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"
#include "model/provenance.hpp"

namespace quadrille {

/// Part of a curve, walked from t0 to t1 (t0 > t1: backwards).
struct ArcPiece {
  int curve = 0;
  double t0 = 0, t1 = 0;
};

enum class NodeKind { irregular, corner, boundary, crossing, cut };

struct GraphNode {
  Vec2 position;
  NodeKind kind = NodeKind::crossing;
  int valence = 4;  ///< interior: quads at the node; on the boundary: quads in its sector (2 = regular)
  int curve = -1;   ///< on the boundary: a CAD curve through it (the outgoing one at a joint); -1 inside
  double t = 0;     ///< its parameter there
};

struct GraphArc {
  int from = 0, to = 0;  ///< nodes
  bool is_boundary = false;
  int length = 0;  ///< prescribed integer length; 0 = free
  std::vector<ArcPiece> pieces;
};

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

/// What can be said for a graph: the way it was made, and what was counted on it.
struct LayoutCertificate {
  std::string way;                  ///< "traced", "quantized" or "t-mesh"; empty: the graph comes without a certificate
  std::string reason;               ///< a sentence for people: why not "traced", where that was tried first; else empty
  int index_sum = 0;                ///< sum (4 - V) over inner and sum (2 - V) over boundary nodes: 4 chi
  std::vector<FaceCount> census;    ///< by rising corners
  int t_junctions = 0;              ///< 0: conforming
  int merged_lines = 0;             ///< pairs of separatrices that met and became one
  int collapsed_chords = 0;         ///< thin strips of blocks taken out
  int laps_cut = 0;                 ///< lines cut short where they pass a node that they reach a lap later
  double largest_turn_degrees = 0;  ///< of any line from the field
};

struct SeparatrixGraph {
  Provenance provenance;
  CadFace face;
  std::vector<Nurbs> splines;
  std::vector<GraphNode> nodes;
  std::vector<GraphArc> arcs;
  std::vector<SeparatrixLine> lines;
  std::vector<int> t_junctions;  ///< nodes where an arc ends on the side of a block; empty for a conforming layout
  LayoutCertificate certificate;

  const Nurbs& curve(int id) const {
    return id < face.num_curves() ? face.curves[id] : splines[id - face.num_curves()];
  }
};

/// sum (4 - V) over inner nodes and sum (2 - V) over those on the boundary.
inline long long index_sum_of(const SeparatrixGraph& graph) {
  long long sum = 0;
  for (const GraphNode& node : graph.nodes) sum += (node.curve < 0 ? 4LL : 2LL) - node.valence;
  return sum;
}

}  // namespace quadrille
