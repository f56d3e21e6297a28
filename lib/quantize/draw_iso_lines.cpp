#include "quantize/draw_iso_lines.hpp"

#include <array>
#include <functional>
#include <utility>

#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "mesh/transfinite.hpp"

namespace quadrille::quantize {
namespace {

constexpr int samples_between = 4;  // of an iso-line, between crossings

/// An iso-line in the unit square: fractions where it starts and ends, both along the direction of the starting side.
struct StraightLine {
  double start = 0, end = 0;
  int from = 0, to = 0;  ///< nodes of the graph
};

/// A node on an iso-line, and the line's parameter in [0, 1] there.
struct LineNode {
  double t = 0;
  int node = 0;
};

// The node at a position of a side, not at its ends.
int node_at(const ArcGraph& t_mesh, const IntegerSides& sides, const SplitArcs& split, int face, int side,
            int position) {
  const auto [h, number] = sides.half_edge_at(face, side, position);
  const int length = sides.arc(h.arc);
  if (number == length) return end_of(t_mesh.arcs, h);
  return split.node_of_crossing.at({h.arc, !h.is_backwards ? number : length - number});
}

// From side `direction` to the opposite one.
std::vector<StraightLine> straight_lines(const ArcGraph& t_mesh, const QuantizedParametrization& p,
                                         const SplitArcs& split, int face, int direction) {
  std::vector<StraightLine> all;
  const int total = p.sides().total(face, direction), opposite = direction + 2;
  for (const int offset : p.lines().lines[face][direction])
    all.push_back({p.side_fraction(face, direction, offset), 1 - p.side_fraction(face, opposite, total - offset),
                   node_at(t_mesh, p.sides(), split, face, direction, offset),
                   node_at(t_mesh, p.sides(), split, face, opposite, total - offset)});
  return all;
}

curve::Chain side_chain(const ArcGraph& t_mesh, const curve::CurveTable& table, const std::vector<HalfEdge>& side) {
  std::vector<ArcPiece> pieces;
  for (const HalfEdge h : side) {
    const std::vector<ArcPiece> directed = graph::pieces_along(t_mesh, h);
    pieces.insert(pieces.end(), directed.begin(), directed.end());
  }
  return curve::Chain(table, pieces);
}

// A spline through all nodes of an iso-line and points between them; it replaces the line from here on.
void add_line(const std::vector<LineNode>& line_nodes, const std::function<Vec2(double)>& position,
              SeparatrixGraph& graph) {
  std::vector<double> t;
  std::vector<Vec2> x;
  for (size_t k = 0; k < line_nodes.size(); ++k) {
    t.push_back(line_nodes[k].t);
    x.push_back(graph.nodes[line_nodes[k].node].position);
    if (k + 1 == line_nodes.size()) break;
    for (int i = 1; i < samples_between; ++i) {
      t.push_back(line_nodes[k].t + (line_nodes[k + 1].t - line_nodes[k].t) * i / samples_between);
      x.push_back(position(t.back()));
    }
  }
  const double h = 1e-4;
  const Vec2 d0 = (-3 * x.front() + 4 * position(h) - position(2 * h)) / (2 * h);
  const Vec2 d1 = (3 * x.back() - 4 * position(1 - h) + position(1 - 2 * h)) / (2 * h);
  const int curve = graph.face.num_curves() + static_cast<int>(graph.splines.size());
  graph.splines.push_back(curve::cubic_spline(t, x, d0, d1));
  SeparatrixLine line{line_nodes.front().node, line_nodes.back().node, LineKind::extended, {}};
  for (size_t k = 0; k + 1 < line_nodes.size(); ++k) {
    const LineNode &a = line_nodes[k], &b = line_nodes[k + 1];
    line.arcs.push_back(static_cast<int>(graph.arcs.size()));
    graph.arcs.push_back({a.node, b.node, false, 0, {{curve, a.t, b.t}}});
  }
  graph.lines.push_back(std::move(line));
}

// Where lines of both directions cross: parameters (s, t) in the unit square, and nodes.
struct Crossings {
  std::vector<std::vector<Vec2>> parameters;
  std::vector<std::vector<int>> nodes;
};

Crossings add_crossings(const std::array<std::vector<StraightLine>, 2>& lines, const mesh::TransfiniteMap& map,
                        SeparatrixGraph& graph) {
  Crossings crossings;
  for (const StraightLine& a : lines[0]) {
    crossings.parameters.emplace_back(), crossings.nodes.emplace_back();
    for (const StraightLine& b : lines[1]) {
      const Vec2 st = mesh::crossing_parameters(a.start, b.start, a.end, b.end);
      crossings.parameters.back().push_back(st);
      crossings.nodes.back().push_back(static_cast<int>(graph.nodes.size()));
      graph.nodes.push_back({map.position(st.x, st.y), NodeKind::crossing, 4, -1, 0});
    }
  }
  return crossings;
}

}  // namespace

// Direction 0 runs from side 0 (t = 0) to side 2, at s from start to end; direction 1 from side 1 (s = 1) to side 3.
void draw_iso_lines(const ArcGraph& t_mesh, const QuantizedParametrization& parametrization, const SplitArcs& split,
                    const curve::CurveTable& table, int face, SeparatrixGraph& graph) {
  const std::array<std::vector<StraightLine>, 2> lines{straight_lines(t_mesh, parametrization, split, face, 0),
                                                       straight_lines(t_mesh, parametrization, split, face, 1)};
  if (lines[0].empty() && lines[1].empty()) return;
  const TFace& sides = parametrization.sides().faces()[face];
  const std::array<curve::Chain, 4> chains{side_chain(t_mesh, table, sides[0]), side_chain(t_mesh, table, sides[1]),
                                           side_chain(t_mesh, table, sides[2]), side_chain(t_mesh, table, sides[3])};
  const mesh::TransfiniteMap map({&chains[0], &chains[1], &chains[2], &chains[3]}, {false, false, false, false});
  const Crossings crossings = add_crossings(lines, map, graph);
  for (size_t i = 0; i < lines[0].size(); ++i) {
    const StraightLine& a = lines[0][i];
    std::vector<LineNode> nodes{{0, a.from}};
    for (size_t j = 0; j < lines[1].size(); ++j) nodes.push_back({crossings.parameters[i][j].y, crossings.nodes[i][j]});
    nodes.push_back({1, a.to});
    add_line(
        nodes, [&](double t) { return map.position(a.start + t * (a.end - a.start), t); }, graph);
  }
  for (size_t j = 0; j < lines[1].size(); ++j) {
    const StraightLine& b = lines[1][j];
    std::vector<LineNode> nodes{{0, b.from}};
    for (size_t i = lines[0].size(); i-- > 0;)
      nodes.push_back({1 - crossings.parameters[i][j].x, crossings.nodes[i][j]});
    nodes.push_back({1, b.to});
    add_line(
        nodes, [&](double r) { return map.position(1 - r, b.start + r * (b.end - b.start)); }, graph);
  }
}

}  // namespace quadrille::quantize
