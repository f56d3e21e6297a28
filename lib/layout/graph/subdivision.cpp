#include "graph/subdivision.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "base/angle.hpp"
#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "curve/nurbs.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

bool is_boundary(const ArcGraph& graph, HalfEdge h) { return graph.arcs[h.arc].is_boundary; }

// The curve and the parameter at which a half-edge starts.
std::pair<int, double> start_on_curve(const ArcGraph& graph, HalfEdge h) {
  const std::vector<ArcPiece>& pieces = graph.arcs[h.arc].pieces;
  return h.is_backwards ? std::pair{pieces.back().curve, pieces.back().t1}
                        : std::pair{pieces.front().curve, pieces.front().t0};
}

// The sectors at a T-junction: half a turn between the two half-edges of the line that continues, independent of the
// angles, as lines turn fast near a node. Empty if no two consecutive half-edges of the three are of one line.
std::vector<int> t_junction_quarters(const ArcGraph& graph, const std::vector<HalfEdge>& half_edges) {
  for (int k = 0; k < 3; ++k) {
    if (start_on_curve(graph, half_edges[k]) != start_on_curve(graph, half_edges[(k + 1) % 3])) continue;
    std::vector<int> quarters(3, 1);
    quarters[k] = 2;
    return quarters;
  }
  return {};
}

std::vector<int> quarters_from_angles(const ArcGraph& graph, int valence, const std::vector<HalfEdge>& half_edges,
                                      bool is_closed) {
  const int num = static_cast<int>(half_edges.size()), num_sectors = is_closed ? num : num - 1;
  if (num_sectors == 1) return {valence};
  std::vector<double> angles;
  angles.reserve(num_sectors);
  for (int k = 0; k < num_sectors; ++k)
    angles.push_back(wrap_two_pi(start_angle(graph, half_edges[(k + 1) % num]) - start_angle(graph, half_edges[k])));
  const double total = is_closed ? 2 * pi : std::accumulate(angles.begin(), angles.end(), 0.0);
  std::vector<int> quarters;
  quarters.reserve(num_sectors);
  for (const double angle : angles) quarters.push_back(static_cast<int>(std::lround(valence * angle / total)));
  return quarters;
}

// A region whose boundary is straight at the node may have no line there, although others have: the widest sectors are
// half turns.
std::vector<int> widest_are_straight(const ArcGraph& graph, int valence, const std::vector<HalfEdge>& half_edges,
                                     int num_sectors) {
  std::vector<std::pair<double, int>> by_width;
  for (int k = 0; k < num_sectors; ++k) {
    const HalfEdge next = half_edges[(k + 1) % half_edges.size()];
    by_width.push_back({-wrap_two_pi(start_angle(graph, next) - start_angle(graph, half_edges[k])), k});
  }
  std::sort(by_width.begin(), by_width.end());
  std::vector<int> quarters(num_sectors, 1);
  for (int k = 0; k < valence - num_sectors; ++k) quarters[by_width[k].second] = 2;
  return quarters;
}

int count_components(const ArcGraph& graph) {
  DisjointSets linked(graph.nodes.size());
  for (const GraphArc& arc : graph.arcs) linked.unite(arc.from, arc.to);
  return static_cast<int>(linked.sets().size());
}

// What a trial has changed, in reverse order; `num`: how many values there were.
template <typename Saved, typename Values>
void restore(Saved& saved, std::size_t num, Values& values) {
  for (auto change = saved.rbegin(); change != saved.rend(); ++change)
    if (change->first < num) values[change->first] = std::move(change->second);
  values.resize(num);
}

}  // namespace

double start_angle(const ArcGraph& graph, HalfEdge h) {
  const GraphArc& arc = graph.arcs[h.arc];
  const ArcPiece& piece = h.is_backwards ? arc.pieces.back() : arc.pieces.front();
  const double t = h.is_backwards ? piece.t1 : piece.t0;
  const bool rises = h.is_backwards != (piece.t0 < piece.t1);
  const Vec2 along = curve::tangent(graph.curve(piece.curve), t, !rises);
  return angle_of(rises ? along : -along);
}

void sort_around_node(const ArcGraph& graph, std::vector<HalfEdge>& half_edges) {
  constexpr double before_all = -1, behind_all = 7;  // radians, outside [0, 2 pi)
  double reference = -pi;
  std::vector<std::pair<double, HalfEdge>> by_angle;
  for (const HalfEdge h : half_edges) {
    by_angle.push_back({start_angle(graph, h), h});
    if (!h.is_backwards && is_boundary(graph, h)) reference = by_angle.back().first;
  }
  for (auto& [angle, h] : by_angle)
    angle = !is_boundary(graph, h) ? wrap_two_pi(angle - reference) : h.is_backwards ? behind_all : before_all;
  std::sort(by_angle.begin(), by_angle.end());
  for (std::size_t k = 0; k < half_edges.size(); ++k) half_edges[k] = by_angle[k].second;
}

std::vector<std::vector<HalfEdge>> half_edges_around_nodes(const ArcGraph& graph) {
  std::vector<std::vector<HalfEdge>> around(graph.nodes.size());
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) around[start_of(graph.arcs, h)].push_back(h);
  for (std::vector<HalfEdge>& half_edges : around) sort_around_node(graph, half_edges);
  return around;
}

std::vector<int> sector_quarters(const ArcGraph& graph, int node, const std::vector<HalfEdge>& half_edges) {
  const int valence = graph.nodes[node].valence, num = static_cast<int>(half_edges.size());
  const bool is_closed = !is_boundary(graph, half_edges.front());
  const int num_sectors = is_closed ? num : num - 1;
  if (num_sectors == valence) return std::vector<int>(num_sectors, 1);
  if (is_closed && num == 3 && graph.nodes[node].kind == NodeKind::crossing)
    if (std::vector<int> quarters = t_junction_quarters(graph, half_edges); !quarters.empty()) return quarters;
  const bool has_interface = std::any_of(half_edges.begin(), half_edges.end(),
                                         [&](HalfEdge h) { return is_on_interface(graph, graph.arcs[h.arc]); });
  if (has_interface && num_sectors < valence && valence <= 2 * num_sectors)
    return widest_are_straight(graph, valence, half_edges, num_sectors);
  return quarters_from_angles(graph, valence, half_edges, is_closed);
}

Subdivision::Subdivision(ArcGraph graph)
    : graph_(std::move(graph)),
      records_(2 * graph_.arcs.size()),
      node_start_(graph_.nodes.size()),
      num_components_(count_components(graph_)) {
  const std::vector<std::vector<HalfEdge>> around = half_edges_around_nodes(graph_);
  for (std::size_t n = 0; n < around.size(); ++n)
    if (!around[n].empty()) link_around(static_cast<int>(n), around[n]);
  number_faces();
}

// `half_edges` are sorted: the reverse of each, which ends at the node, is followed by the half-edge before it, the
// next one clockwise.
void Subdivision::link_around(int node, const std::vector<HalfEdge>& half_edges) {
  node_start_[node] = half_edges.front();
  const std::vector<int> quarters = sector_quarters(graph_, node, half_edges);
  for (std::size_t k = 0; k < quarters.size(); ++k) {
    const HalfEdge incoming = half_edges[(k + 1) % half_edges.size()].reversed();
    record(incoming) = {half_edges[k], -1, quarters[k]};
  }
}

void Subdivision::label(HalfEdge first, int face) {
  HalfEdge h = first;
  do {
    if (h.arc < 0) throw ComputeError("the arcs of a separatrix graph do not close around one of its nodes");
    record(h).face = face;
    h = next(h);
  } while (h != first);
}

// Numbers faces by their lowest half-edge. The outside of the boundary is no face.
void Subdivision::number_faces() {
  for (Record& r : records_) r.face = -1;
  face_start_.clear();
  for (int a = 0; a < arc_bound(); ++a)
    for (const HalfEdge h : {HalfEdge{a}, HalfEdge{a, true}}) {
      if (is_inside(h) || (h.is_backwards && graph_.arcs[a].is_boundary)) continue;
      label(h, static_cast<int>(face_start_.size()));
      face_start_.push_back(h);
    }
}

int Subdivision::num_faces() const {
  return static_cast<int>(std::count_if(face_start_.begin(), face_start_.end(), [](HalfEdge h) { return h.arc >= 0; }));
}

HalfEdge Subdivision::previous(HalfEdge h) const {
  HalfEdge p = h;
  while (next(p) != h) p = next(p);
  return p;
}

std::vector<HalfEdge> Subdivision::cycle(int face) const {
  std::vector<HalfEdge> all;
  const HalfEdge first = face_start_[face];
  if (first.arc < 0) return all;
  HalfEdge h = first;
  do {
    all.push_back(h);
    h = next(h);
  } while (h != first);
  std::rotate(all.begin(), std::min_element(all.begin(), all.end()), all.end());
  return all;
}

int Subdivision::num_corners(int face) const {
  int corners = 0;
  for (const HalfEdge h : cycle(face)) corners += 2 - quarters(h);
  return corners;
}

std::vector<HalfEdge> Subdivision::around(int node) const {
  std::vector<HalfEdge> all;
  const HalfEdge first = node_start_[node];
  if (first.arc < 0) return all;
  // The next half-edge counter-clockwise is the reverse of the previous one of the face. On the boundary the first is
  // the boundary arc that starts there, and the last has no face.
  HalfEdge h = first;
  do {
    all.push_back(h);
    if (!is_inside(h)) break;
    h = previous(h).reversed();
  } while (h != first);
  return all;
}

std::vector<int> Subdivision::compact() {
  std::vector<int> arc2arc(graph_.arcs.size(), -1), node2node(graph_.nodes.size(), -1);
  int num_arcs = 0, num_nodes = 0;
  for (int a = 0; a < arc_bound(); ++a)
    if (has_arc(a)) arc2arc[a] = num_arcs++;
  for (int n = 0; n < node_bound(); ++n)
    if (node_start_[n].arc >= 0) node2node[n] = num_nodes++;
  for (int n = 0; n < node_bound(); ++n) {
    if (node2node[n] < 0) continue;
    graph_.nodes[node2node[n]] = graph_.nodes[n];
    node_start_[node2node[n]] = {arc2arc[node_start_[n].arc], node_start_[n].is_backwards};
  }
  graph_.nodes.resize(num_nodes), node_start_.resize(num_nodes);
  for (int a = 0; a < arc_bound(); ++a) {
    const int to = arc2arc[a];
    if (to < 0) continue;
    if (to != a) graph_.arcs[to] = std::move(graph_.arcs[a]);
    GraphArc& arc = graph_.arcs[to];
    arc.from = node2node[arc.from], arc.to = node2node[arc.to];
    for (const bool is_backwards : {false, true}) {
      Record& moved = record({to, is_backwards});
      moved = record({a, is_backwards});
      if (moved.next.arc >= 0) moved.next.arc = arc2arc[moved.next.arc];
    }
  }
  graph_.arcs.resize(num_arcs), records_.resize(2 * static_cast<std::size_t>(num_arcs));
  number_faces();
  return arc2arc;
}

void Subdivision::begin_trial() {
  Trial trial;
  trial.num_arcs = graph_.arcs.size(), trial.num_nodes = graph_.nodes.size();
  trial.num_faces = face_start_.size(), trial.num_splines = graph_.splines.size();
  trial_ = std::move(trial);
}

void Subdivision::undo_trial() {
  Trial trial = std::move(*trial_);
  trial_.reset();
  restore(trial.records, 2 * trial.num_arcs, records_);
  restore(trial.arcs, trial.num_arcs, graph_.arcs);
  restore(trial.nodes, trial.num_nodes, graph_.nodes);
  restore(trial.node_starts, trial.num_nodes, node_start_);
  restore(trial.face_starts, trial.num_faces, face_start_);
  graph_.splines.resize(trial.num_splines);
}

}  // namespace quadrille::graph
