#pragma once
// A planar subdivision: a domain cut into faces by arcs on curves, with its topology.
//
// The geometry is an ArcGraph (model/arc_graph.hpp). The topology is a table over half-edges (model/arc_graph.hpp):
//
//        ^                next(h)      the half-edge that follows h around the face on its left
//        | next(h)        face(h)      that face; -1 where the outside of the domain is on the left
//        |                quarters(h)  quarter turns of the cross between h and next(h), inside the face, at the node
//   ---- o <----- h ----               where h ends: 1 at the corner of a block, 2 on a straight side
//
// A face is a cycle h, next(h), next(next(h)), ... that has it on the left. It has sum (2 - quarters) corners, and the
// quarters around a node add up to its valence. In a domain whose graph is not connected an annular face has two
// cycles, and each counts as a face.
//
// A subdivision is built from a graph once, from the order of half-edges around nodes by the directions of their
// curves. From then on it is changed only by the operations below, which evaluate no angle and whose cost is
// proportional to the change. Each results in the subdivision that would be built from the changed graph, up to the
// numbers. Numbers stay valid during consecutive operations: new nodes, arcs and faces are numbered after the others,
// and the numbers of removed ones are not used again. `compact` closes the gaps; then even the numbers are those of a
// subdivision built from the graph.
//
// Copies are independent values. To try operations without the cost of a copy, begin a trial, and keep or undo it.

#include <optional>
#include <utility>
#include <vector>

#include "model/arc_graph.hpp"

namespace quadrille::graph {

/// Angle of a half-edge's tangent where it starts, radians in (-pi, pi].
double start_angle(const ArcGraph& graph, HalfEdge h);

/// Sorts half-edges that start at one node, counter-clockwise. On the boundary the first runs along the boundary with
/// the domain on its left and the last runs against it, independent of the rounding of their angles.
void sort_around_node(const ArcGraph& graph, std::vector<HalfEdge>& half_edges);

/// The sorted half-edges that start at each node.
std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const ArcGraph& graph);

/// Quarter turns of the cross in the sectors between consecutive half-edges of a sorted, not empty list around `node`;
/// inside the domain the last sector lies between the last and the first. If all lines of the node are present, each
/// sector is one quarter; at a T-junction one sector is two quarters; else the valence is divided in proportion to the
/// angles.
std::vector<int> sector_quarters(const ArcGraph& graph, int node, const std::vector<HalfEdge>& half_edges);

class Subdivision {
 public:
  Subdivision() = default;

  /// Builds the topology, at the cost of sorting around each node. Throws ComputeError if the boundary arcs at a node
  /// are not consecutive.
  explicit Subdivision(ArcGraph graph);

  const ArcGraph& graph() const { return graph_; }

  /// Number of faces, arcs and nodes ever made since the last compact(); some may have been removed.
  int face_bound() const { return static_cast<int>(face_start_.size()); }
  int arc_bound() const { return static_cast<int>(graph_.arcs.size()); }
  int node_bound() const { return static_cast<int>(graph_.nodes.size()); }
  int num_faces() const;
  /// Number of connected parts of the graph; if above 1, some face has a hole.
  int num_components() const { return num_components_; }

  bool has_arc(int arc) const { return face({arc}) >= 0; }
  bool has_face(int face) const { return face_start_[face].arc >= 0; }
  int start(HalfEdge h) const { return start_of(graph_.arcs, h); }
  int end(HalfEdge h) const { return end_of(graph_.arcs, h); }
  HalfEdge next(HalfEdge h) const { return record(h).next; }
  HalfEdge previous(HalfEdge h) const;  ///< cost: linear in the sides of the face
  int face(HalfEdge h) const { return record(h).face; }
  int quarters(HalfEdge h) const { return record(h).quarters; }
  /// The half-edges of a face, counter-clockwise, from its lowest one on.
  std::vector<HalfEdge> cycle(int face) const;
  int num_corners(int face) const;
  /// The half-edges that start at a node, counter-clockwise; at a node of the boundary from the boundary arc that
  /// starts there to the one that ends there.
  std::vector<HalfEdge> around(int node) const;

  /// All operations from here on up to undo_trial() can be undone, at the cost of the changes; after keep_trial() they
  /// cannot any more. Trials are not nested. Numbers stay valid: there is no compact(), drop_unused_splines() or
  /// release() during a trial.
  void begin_trial();
  void keep_trial() { trial_.reset(); }
  void undo_trial();

  /// Divides an arc at a new node: interior of valence 4, or of valence 2 on the boundary. `first` and `second` are the
  /// two parts of h, in its direction, with these pieces. The arc keeps its number and becomes its part before the node
  /// in its own direction; the other part is new.
  struct Division {
    int node = -1;
    HalfEdge first, second;
  };
  Division divide_arc(HalfEdge h, const GraphNode& node, std::vector<ArcPiece> first, std::vector<ArcPiece> second);

  /// The position of one end of a new arc in the topology: it ends where `after` does, in the sector between `after`
  /// and next(after), of which `quarters` remain between `after` and the new arc.
  struct Sector {
    HalfEdge after;
    int quarters = 1;
  };
  /// Divides a face by a new inner arc between two different corners of its cycle. The part on the left of the new
  /// half-edge keeps the face's number.
  HalfEdge insert_arc(const Sector& from, const Sector& to, std::vector<ArcPiece> pieces);

  /// Unites the two faces beside an inner arc. Returns false without any change if both sides are the same face.
  bool remove_arc(int arc);

  /// The inverse of divide_arc: the only two arcs at a node become a new one with the pieces of both. Returns false
  /// without any change if the node has another number of arcs or is a corner.
  bool dissolve_node(int node);

  /// Shrinks an arc to the node where h starts; the node where it ends is removed, and its other arcs start here. The
  /// caller must lengthen their curves. A node on the boundary must not be merged into one inside, nor two of the
  /// boundary through an inner arc.
  void merge_ends(HalfEdge h);

  /// Replaces the shape of an inner arc; it then runs in the direction of h.
  void reshape_arc(HalfEdge h, std::vector<ArcPiece> pieces);
  void set_pieces(int arc, std::vector<ArcPiece> pieces) { changing_arc(arc).pieces = std::move(pieces); }
  void move_node(int node, Vec2 position) { changing_node(node).position = position; }
  /// Moves a node along the boundary, to parameter t of a CAD curve. The caller must change the arcs at the node.
  void move_boundary_node(int node, Vec2 position, int curve, double t);
  /// Returns the number of the curve (ArcGraph::curve).
  int add_spline(Nurbs spline);
  /// Removes splines that no arc uses, and renumbers the others.
  void drop_unused_splines();
  /// Moves the graph out; the topology is invalid afterwards.
  ArcGraph release() { return std::move(graph_); }

  /// Closes the gaps in the numbers of nodes and arcs, and numbers faces by their lowest half-edge. Returns the new
  /// number of each arc, -1 if it was removed.
  std::vector<int> compact();

 private:
  /// What is known of a half-edge, besides its arc.
  struct Record {
    HalfEdge next;
    int face = -1;
    int quarters = 0;
  };
  /// The state before a trial of what it has changed, as often as that was changed, and the numbers of everything.
  struct Trial {
    template <typename Value>
    using Saved = std::vector<std::pair<std::size_t, Value>>;
    Saved<Record> records;
    Saved<GraphArc> arcs;
    Saved<GraphNode> nodes;
    Saved<HalfEdge> node_starts, face_starts;
    std::size_t num_arcs = 0, num_nodes = 0, num_faces = 0, num_splines = 0;
  };
  const Record& record(HalfEdge h) const { return records_[h.index()]; }
  // What is changed is obtained from these, which record it for a trial first.
  template <typename Value>
  Value& changing(Trial::Saved<Value> Trial::*saved, std::vector<Value>& values, std::size_t number) {
    if (trial_) (*trial_.*saved).emplace_back(number, values[number]);
    return values[number];
  }
  Record& record(HalfEdge h) { return changing(&Trial::records, records_, h.index()); }
  GraphArc& changing_arc(int arc) { return changing(&Trial::arcs, graph_.arcs, arc); }
  GraphNode& changing_node(int node) { return changing(&Trial::nodes, graph_.nodes, node); }
  HalfEdge& changing_node_start(int node) { return changing(&Trial::node_starts, node_start_, node); }
  HalfEdge& changing_face_start(int face) { return changing(&Trial::face_starts, face_start_, face); }
  bool is_inside(HalfEdge h) const { return face(h) >= 0; }
  void link_around(int node, const std::vector<HalfEdge>& half_edges);
  HalfEdge add_arc(int from, int to, bool is_boundary, std::vector<ArcPiece> pieces);
  void retire(int arc);
  void number_faces();
  void label(HalfEdge first, int face);
  void turn(int arc);

  ArcGraph graph_;
  std::vector<Record> records_;       ///< by HalfEdge::index()
  std::vector<HalfEdge> node_start_;  ///< of each node: one that starts there, on the boundary the boundary arc
  std::vector<HalfEdge> face_start_;  ///< of each face: one of its cycle
  int num_components_ = 0;
  std::optional<Trial> trial_;
};

}  // namespace quadrille::graph
