#pragma once
// A planar graph of arcs on curves: what separatrix graphs and block layouts have in common.
//
// Arcs meet only at nodes. Every arc is a chain of pieces of curves: of the CAD face (curve < face.num_curves()) or of
// `splines` (curve - face.num_curves()). A node is a point at which the TOPOLOGY changes: an irregular node, a corner,
// an end of a separatrix on the boundary, or a crossing. A joint with V = 2 at which no separatrix ends is not a node:
// it lies inside an arc, between two pieces. Boundary arcs run with the face on their left.

#include <compare>
#include <cstddef>
#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille {

/// Part of a curve, traversed from t0 to t1 (t0 > t1: backwards).
struct ArcPiece {
  int curve = 0;
  double t0 = 0, t1 = 0;
};

/// Of several regions: `interface` is inside an interface and ends lines of one or both neighbours; `junction` is a
/// joint of interfaces that is not on the boundary of the whole. A joint on the boundary of the whole is a `corner`.
enum class NodeKind { irregular, corner, boundary, crossing, cut, interface, junction };
constexpr auto enum_names(NodeKind) {
  return std::to_array({"irregular", "corner", "boundary", "crossing", "cut", "interface", "junction"});
}

struct GraphNode {
  Vec2 position;
  NodeKind kind = NodeKind::crossing;
  int valence = 4;  ///< interior: quads at the node; on the boundary: quads in its sector (2: regular)
  /// On the boundary or an interface: a CAD curve through it (the outgoing one at a joint); -1 inside a region.
  int curve = -1;
  double t = 0;  ///< its parameter there

  /// Whether the face surrounds the node: it is inside a region, or on interfaces alone.
  bool is_inner() const { return curve < 0 || kind == NodeKind::interface || kind == NodeKind::junction; }
};

struct GraphArc {
  int from = 0, to = 0;  ///< nodes
  bool is_boundary = false;
  int length = 0;  ///< prescribed integer length; 0 = free
  std::vector<ArcPiece> pieces;
};

struct ArcGraph {
  CadFace face;
  std::vector<Nurbs> splines;
  std::vector<GraphNode> nodes;
  std::vector<GraphArc> arcs;
  /// Ascending: the curves of interfaces that nothing crosses, of both sides: each side has nodes of its own.
  std::vector<int> open_curves;

  const Nurbs& curve(int id) const {
    return id < face.num_curves() ? face.curves[id] : splines[id - face.num_curves()];
  }
};

/// sum (4 - V) over interior nodes plus sum (2 - V) over boundary nodes.
inline long long index_sum_of(const ArcGraph& graph) {
  long long sum = 0;
  for (const GraphNode& node : graph.nodes) sum += (node.is_inner() ? 4LL : 2LL) - node.valence;
  return sum;
}

/// An arc in one of its two directions: the side of a face, a step of a path, a line as it starts at a node.
///
///     arc 7:   from o------------>o to       {7}        forwards: from `from` to `to`, the arc's left side
///                                            {7, true}  backwards: from `to` to `from`, the arc's right side
struct HalfEdge {
  int arc = -1;
  bool is_backwards = false;

  constexpr HalfEdge reversed() const { return {arc, !is_backwards}; }
  /// Index in tables over half-edges: 2 * arc forwards, 2 * arc + 1 backwards.
  constexpr std::size_t index() const { return 2 * static_cast<std::size_t>(arc) + (is_backwards ? 1 : 0); }
  constexpr auto operator<=>(const HalfEdge&) const = default;  ///< by index
};

/// The start node and the end node of a half-edge. `arcs` have members `from` and `to`.
template <typename Arcs>
int start_of(const Arcs& arcs, HalfEdge h) {
  return h.is_backwards ? arcs[h.arc].to : arcs[h.arc].from;
}
template <typename Arcs>
int end_of(const Arcs& arcs, HalfEdge h) {
  return start_of(arcs, h.reversed());
}

/// The code in files (formats/block-layout.md): arc forwards, -1 - arc backwards.
constexpr int file_code(HalfEdge h) { return h.is_backwards ? -1 - h.arc : h.arc; }
constexpr HalfEdge half_edge_of_code(int code) { return code < 0 ? HalfEdge{-1 - code, true} : HalfEdge{code, false}; }

}  // namespace quadrille
