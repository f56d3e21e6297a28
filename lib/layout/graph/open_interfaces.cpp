#include "graph/open_interfaces.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "base/error.hpp"
#include "curve/named_places.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/subdivision.hpp"
#include "model/interfaces.hpp"

namespace quadrille::graph {
namespace {

/// The half-edges around a node, and the quarters of the sectors behind them, before anything is opened.
struct Ring {
  std::vector<HalfEdge> half_edges;
  std::vector<int> quarters;
  bool is_closed = true;  ///< the node is inside
};

std::vector<Ring> rings_of(const ArcGraph& graph) {
  const std::vector<std::vector<HalfEdge>> around = half_edges_around_nodes(graph);
  std::vector<Ring> rings;
  for (std::size_t n = 0; n < around.size(); ++n) {
    Ring ring{around[n], {}, true};
    if (!ring.half_edges.empty()) {
      ring.quarters = sector_quarters(graph, static_cast<int>(n), ring.half_edges);
      ring.is_closed = !graph.arcs[ring.half_edges.front().arc].is_boundary;
    }
    rings.push_back(std::move(ring));
  }
  return rings;
}

/// The steps of a line, each an arc in the line's direction.
std::vector<std::vector<HalfEdge>> steps_of_lines(const SeparatrixGraph& graph) {
  std::vector<std::vector<HalfEdge>> all;
  for (const SeparatrixLine& line : graph.lines) {
    std::vector<HalfEdge> steps;
    for (int node = line.origin; const int arc : line.arcs) {
      steps.push_back({arc, graph.arcs[arc].from != node});
      node = end_of(graph.arcs, steps.back());
    }
    all.push_back(std::move(steps));
  }
  return all;
}

class Opener {
 public:
  Opener(SeparatrixGraph& graph, const std::vector<bool>& is_open) : graph_(graph), second_(graph.arcs.size(), -1) {
    for (GraphArc& arc : graph_.arcs)
      if (is_on_interface(graph_, arc) && is_open[arc.pieces.front().curve]) run_along_curve(arc);
    rings_ = rings_of(graph_);
    steps_ = steps_of_lines(graph_);
    for (int a = 0, count = static_cast<int>(graph_.arcs.size()); a < count; ++a)
      if (is_on_interface(graph_, graph_.arcs[a]) && is_open[graph_.arcs[a].pieces.front().curve]) double_arc(a);
  }

  void open() {
    for (std::size_t n = 0; n < rings_.size(); ++n) divide(static_cast<int>(n));
    divide_lines();
  }

 private:
  bool is_opened(HalfEdge h) const { return second_[h.arc] >= 0; }

  /// With the curve, as boundary arcs do.
  static void run_along_curve(GraphArc& arc) {
    if (arc.pieces.front().t0 < arc.pieces.front().t1) return;
    std::swap(arc.from, arc.to);
    arc.pieces = reversed_pieces(std::move(arc.pieces));
  }

  void double_arc(int a) {
    GraphArc other = graph_.arcs[a];
    std::swap(other.from, other.to);
    std::reverse(other.pieces.begin(), other.pieces.end());
    for (ArcPiece& piece : other.pieces) {
      const PartnerPoint start = partner_point(graph_.face, piece.curve, piece.t1);
      piece = {start.curve, start.t, partner_point(graph_.face, piece.curve, piece.t0).t};
    }
    second_[a] = static_cast<int>(graph_.arcs.size());
    graph_.arcs.push_back(std::move(other));
  }

  /// A node for each sector between open half-edges; the first keeps the number.
  void divide(int n) {
    const Ring ring = rings_[n];
    const int count = static_cast<int>(ring.half_edges.size());
    const auto first =
        std::find_if(ring.half_edges.begin(), ring.half_edges.end(), [this](HalfEdge h) { return is_opened(h); });
    if (first == ring.half_edges.end()) return;
    const bool was_inside_curve = graph_.nodes[n].kind == NodeKind::interface;
    // Around an inner node the first sector begins at an open half-edge, on the boundary at the boundary.
    const int begin = ring.is_closed ? static_cast<int>(first - ring.half_edges.begin()) : 0;
    int node = n, valence = 0;
    for (int k = 0; k < count; ++k) {
      const int at = (begin + k) % count;
      const HalfEdge h = ring.half_edges[at];
      if (is_opened(h) && k > 0) {
        end_at(h, node);
        finish(node, valence, was_inside_curve);
        node = static_cast<int>(graph_.nodes.size()), valence = 0;
        graph_.nodes.push_back(graph_.nodes[n]);
      }
      if (is_opened(h) || (k == 0 && !ring.is_closed))
        start_at(h, node);
      else
        (h.is_backwards ? graph_.arcs[h.arc].to : graph_.arcs[h.arc].from) = node;
      if (at < static_cast<int>(ring.quarters.size())) valence += ring.quarters[at];
    }
    if (ring.is_closed) end_at(*first, node);
    finish(node, valence, was_inside_curve);
  }

  /// The boundary arc on the counter-clockwise side of an open half-edge, or of the boundary, starts at the node.
  void start_at(HalfEdge h, int node) {
    const int arc = h.is_backwards ? second_[h.arc] : h.arc;
    graph_.arcs[arc].from = node;
    graph_.nodes[node].curve = graph_.arcs[arc].pieces.front().curve;
    graph_.nodes[node].t = graph_.arcs[arc].pieces.front().t0;
  }

  /// That on its clockwise side ends there.
  void end_at(HalfEdge h, int node) { graph_.arcs[h.is_backwards ? h.arc : second_[h.arc]].to = node; }

  void finish(int node, int valence, bool was_inside_curve) {
    graph_.nodes[node].valence = valence;
    graph_.nodes[node].kind = was_inside_curve ? NodeKind::boundary : NodeKind::corner;
  }

  /// A line that crosses an opened interface ends on it, and another begins on the other side.
  void divide_lines() {
    for (std::size_t a = 0; a < second_.size(); ++a)
      if (second_[a] >= 0) graph_.arcs[a].is_boundary = graph_.arcs[second_[a]].is_boundary = true;
    std::vector<SeparatrixLine> lines;
    for (std::size_t l = 0; l < steps_.size(); ++l)
      for (const HalfEdge step : steps_[l]) {
        const int start = start_of(graph_.arcs, step);
        if (step == steps_[l].front() || lines.back().end != start)
          lines.push_back({start, start, graph_.lines[l].kind, {}});
        lines.back().arcs.push_back(step.arc);
        lines.back().end = end_of(graph_.arcs, step);
      }
    graph_.lines = std::move(lines);
    if (graph_.certificate.method) graph_.certificate.index_sum = static_cast<int>(index_sum_of(graph_));
  }

  SeparatrixGraph& graph_;
  std::vector<int> second_;  ///< by arc: the one on the other side of an open interface, or -1
  std::vector<Ring> rings_;
  std::vector<std::vector<HalfEdge>> steps_;
};

}  // namespace

CadFace with_open_curves(CadFace face, const std::vector<std::string>& names, const std::string& option) {
  const CadFace closed = face;
  for (const std::string& name : names)
    for (const int curve : curve::named_curves(face, name, option)) {
      if (!closed.is_interface(curve))
        throw UsageError(fmt::format("{} {}: the curve {} is a boundary, not between two regions or inside one", option,
                                     name, curve));
      face.partners[closed.partners[curve]] = -1;
      face.partners[curve] = -1;
    }
  return face;
}

std::vector<std::string> nonconforming_interfaces(const std::vector<std::string>& options) {
  std::vector<std::string> names;
  for (const std::string& option : options) {
    const std::size_t end = option.rfind('=');
    if (end == std::string::npos || end == 0 || option.substr(end + 1) != "nonconforming")
      throw UsageError(fmt::format("--interface {}: expected NAME=nonconforming", option));
    names.push_back(option.substr(0, end));
  }
  return names;
}

void open_interfaces(SeparatrixGraph& graph, const std::vector<bool>& is_open) { Opener(graph, is_open).open(); }

}  // namespace quadrille::graph
