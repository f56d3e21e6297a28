#include "graph/subdivision.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/disjoint_sets.hpp"
#include "base/error.hpp"
#include "graph/node_rotation.hpp"

namespace quadrille::graph {
namespace {

int count_components(const ArcGraph& graph) {
  DisjointSets linked(graph.nodes.size());
  for (const GraphArc& arc : graph.arcs) linked.unite(arc.from, arc.to);
  int count = 0;
  for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) count += linked.find(n) == n;
  return count;
}

}  // namespace

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
  if (graph_.arcs[first.arc].is_boundary) {
    // The next half-edge counter-clockwise is the reverse of the previous one of the face.
    for (HalfEdge h = first;; h = previous(h).reversed()) {
      all.push_back(h);
      if (!is_inside(h)) return all;
    }
  }
  HalfEdge h = first;
  do {
    all.push_back(h);
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

}  // namespace quadrille::graph
