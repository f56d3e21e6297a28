#include "quantize/extend_lines.hpp"

#include <algorithm>
#include <array>
#include <map>

#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "mesh/transfinite.hpp"
#include "quantize/integer_grid.hpp"

namespace quadrille::quantize {
namespace {

constexpr int samples_between = 4;  // of a grid line, between crossings

std::vector<ArcPiece> reversed_pieces(std::vector<ArcPiece> pieces) {
  std::reverse(pieces.begin(), pieces.end());
  for (ArcPiece& piece : pieces) std::swap(piece.t0, piece.t1);
  return pieces;
}

class Extender {
 public:
  Extender(const SeparatrixGraph& t_mesh, const std::vector<TFace>& faces, const IntegerSides& lengths,
           const GridLines& grid)
      : t_mesh_(t_mesh), faces_(faces), lengths_(lengths), grid_(grid), table_(t_mesh.face, t_mesh.splines) {
    graph.provenance = t_mesh.provenance;
    graph.face = t_mesh.face;
    graph.certificate = t_mesh.certificate;
    graph.splines = t_mesh.splines;
    graph.nodes = t_mesh.nodes;
    for (const GraphArc& arc : t_mesh.arcs) chains_.emplace_back(table_, arc.pieces);
    for (const curve::Chain& chain : chains_) arc_lengths_.push_back(chain.length());
    shares_ = mark_shares(lengths, grid, arc_lengths_);
    for (int a = 0; a < static_cast<int>(t_mesh.arcs.size()); ++a) split_arc(a);
    keep_lines();
    for (int f = 0; f < static_cast<int>(faces.size()); ++f) draw_face(f);
  }

  SeparatrixGraph graph;

 private:
  void split_arc(int a) {
    const GraphArc& arc = t_mesh_.arcs[a];
    parts_.emplace_back();
    ArcPiece rest = arc.pieces.front();
    size_t k = 0;
    int from = arc.from;
    std::vector<ArcPiece> pieces;
    const auto finish = [&](int to) {
      parts_[a].push_back(static_cast<int>(graph.arcs.size()));
      graph.arcs.push_back({from, to, arc.is_boundary, 0, pieces});
      pieces.clear();
      from = to;
    };
    for (const auto& [number, share] : shares_[a]) {
      const curve::ChainPoint at = chains_[a].at(share);
      for (; static_cast<int>(k) < at.piece; rest = arc.pieces[++k]) pieces.push_back(rest);
      if (rest.t0 != at.t) pieces.push_back({rest.curve, rest.t0, at.t});
      rest.t0 = at.t;
      const int node = static_cast<int>(graph.nodes.size());
      graph.nodes.push_back(arc.is_boundary ? GraphNode{at.position, NodeKind::boundary, 2, rest.curve, at.t}
                                            : GraphNode{at.position, NodeKind::crossing, 4, -1, 0});
      node_of_mark_[{a, number}] = node;
      finish(node);
    }
    pieces.push_back(rest);
    for (++k; k < arc.pieces.size(); ++k) pieces.push_back(arc.pieces[k]);
    finish(arc.to);
  }

  void keep_lines() {
    for (SeparatrixLine line : t_mesh_.lines) {
      std::vector<int> arcs;
      for (const int a : line.arcs) arcs.insert(arcs.end(), parts_[a].begin(), parts_[a].end());
      line.arcs = std::move(arcs);
      graph.lines.push_back(std::move(line));
    }
  }

  // The node at a position of a side, not at its ends.
  int node_at(int face, int side, int position) const {
    const auto [h, number] = lengths_.half_edge_at(face, side, position);
    const int arc = h.arc, length = lengths_.arc(arc);
    if (number == length) return end_of(t_mesh_.arcs, h);
    return node_of_mark_.at({arc, !h.is_backwards ? number : length - number});
  }

  double fraction_at(int face, int side, int position) const {
    return side_fraction(lengths_, shares_, arc_lengths_, face, side, position);
  }

  curve::Chain side_chain(int face, int side) const {
    std::vector<ArcPiece> pieces;
    for (const HalfEdge h : faces_[face][side]) {
      const std::vector<ArcPiece>& own = t_mesh_.arcs[h.arc].pieces;
      const std::vector<ArcPiece> directed = h.is_backwards ? reversed_pieces(own) : own;
      pieces.insert(pieces.end(), directed.begin(), directed.end());
    }
    return curve::Chain(table_, pieces);
  }

  /// A grid line in the unit square: fractions where it starts and ends, both along the direction of the starting side.
  struct Straight {
    int offset = 0;
    double start = 0, end = 0;
  };

  std::vector<Straight> straight_lines(int face, int direction) const {
    std::vector<Straight> all;
    const int total = lengths_.total(face, direction);
    for (const int offset : grid_.lines[face][direction])
      all.push_back(
          {offset, fraction_at(face, direction, offset), 1 - fraction_at(face, direction + 2, total - offset)});
    return all;
  }

  void draw_face(int f) {
    const std::array<std::vector<Straight>, 2> lines{straight_lines(f, 0), straight_lines(f, 1)};
    if (lines[0].empty() && lines[1].empty()) return;
    const std::array<curve::Chain, 4> sides{side_chain(f, 0), side_chain(f, 1), side_chain(f, 2), side_chain(f, 3)};
    const mesh::TransfiniteMap map({&sides[0], &sides[1], &sides[2], &sides[3]}, {false, false, false, false});
    // Direction 0 runs from side 0 (t = 0) to side 2, at s from start to end; direction 1 from side 1 (s = 1) to
    // side 3.
    std::vector<std::vector<Vec2>> where;
    std::vector<std::vector<int>> nodes;
    for (const Straight& a : lines[0]) {
      where.emplace_back(), nodes.emplace_back();
      for (const Straight& b : lines[1]) {
        const Vec2 st = mesh::crossing_parameters(a.start, b.start, a.end, b.end);
        where.back().push_back(st);
        nodes.back().push_back(static_cast<int>(graph.nodes.size()));
        graph.nodes.push_back({map.position(st.x, st.y), NodeKind::crossing, 4, -1, 0});
      }
    }
    for (size_t i = 0; i < lines[0].size(); ++i) {
      const Straight& a = lines[0][i];
      std::vector<Stop> stops{{0, node_at(f, 0, a.offset)}};
      for (size_t j = 0; j < lines[1].size(); ++j) stops.push_back({where[i][j].y, nodes[i][j]});
      stops.push_back({1, node_at(f, 2, lengths_.total(f, 2) - a.offset)});
      draw(stops, [&](double t) { return map.position(a.start + t * (a.end - a.start), t); });
    }
    for (size_t j = 0; j < lines[1].size(); ++j) {
      const Straight& b = lines[1][j];
      std::vector<Stop> stops{{0, node_at(f, 1, b.offset)}};
      for (size_t i = lines[0].size(); i-- > 0;) stops.push_back({1 - where[i][j].x, nodes[i][j]});
      stops.push_back({1, node_at(f, 3, lengths_.total(f, 3) - b.offset)});
      draw(stops, [&](double r) { return map.position(1 - r, b.start + r * (b.end - b.start)); });
    }
  }

  struct Stop {
    double t = 0;
    int node = 0;
  };

  // A spline through all nodes of a grid line and points between them; it IS the line from here on.
  template <class Position>
  void draw(const std::vector<Stop>& stops, const Position& position) {
    std::vector<double> t;
    std::vector<Vec2> x;
    for (size_t k = 0; k < stops.size(); ++k) {
      t.push_back(stops[k].t);
      x.push_back(graph.nodes[stops[k].node].position);
      if (k + 1 == stops.size()) break;
      for (int i = 1; i < samples_between; ++i) {
        t.push_back(stops[k].t + (stops[k + 1].t - stops[k].t) * i / samples_between);
        x.push_back(position(t.back()));
      }
    }
    const double h = 1e-4;
    const Vec2 d0 = (-3 * x.front() + 4 * position(h) - position(2 * h)) / (2 * h);
    const Vec2 d1 = (3 * x.back() - 4 * position(1 - h) + position(1 - 2 * h)) / (2 * h);
    const int curve = graph.face.num_curves() + static_cast<int>(graph.splines.size());
    graph.splines.push_back(curve::cubic_spline(t, x, d0, d1));
    SeparatrixLine line{stops.front().node, stops.back().node, "extended", {}};
    for (size_t k = 0; k + 1 < stops.size(); ++k) {
      line.arcs.push_back(static_cast<int>(graph.arcs.size()));
      graph.arcs.push_back({stops[k].node, stops[k + 1].node, false, 0, {{curve, stops[k].t, stops[k + 1].t}}});
    }
    graph.lines.push_back(std::move(line));
  }

  const SeparatrixGraph& t_mesh_;
  const std::vector<TFace>& faces_;
  const IntegerSides& lengths_;
  const GridLines& grid_;
  curve::CurveTable table_;
  std::vector<curve::Chain> chains_;  // of the arcs
  std::vector<double> arc_lengths_;
  std::vector<std::map<int, double>> shares_;  // of the marked points of each arc
  std::vector<std::vector<int>> parts_;        // new arcs of each arc
  std::map<std::pair<int, int>, int> node_of_mark_;
};

}  // namespace

SeparatrixGraph extend_lines(const SeparatrixGraph& t_mesh, const std::vector<TFace>& faces,
                             const std::vector<int>& lengths) {
  const IntegerSides table(faces, lengths);
  const GridLines grid(t_mesh, table);
  SeparatrixGraph graph = std::move(Extender(t_mesh, faces, table, grid).graph);
  graph::require_four_corners(graph);
  return graph;
}

}  // namespace quadrille::quantize
