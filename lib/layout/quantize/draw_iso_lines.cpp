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

/// An iso-line in the unit square: fractions where it starts and ends, both along the direction of the starting side,
/// and the half-edges of the two sides that end there.
struct StraightLine {
  double start = 0, end = 0;
  HalfEdge from, to;
};

// From side `direction` to the opposite one.
std::vector<StraightLine> straight_lines(const ParametrizedTMesh& t_mesh, int face, int direction) {
  std::vector<StraightLine> all;
  const QuantizedParametrization& p = t_mesh.parametrization;
  const int total = p.sides().total(face, direction), opposite = direction + 2;
  for (const int offset : p.lines().lines[face][direction])
    all.push_back({p.side_fraction(face, direction, offset), 1 - p.side_fraction(face, opposite, total - offset),
                   part_before(p, t_mesh.parts, face, direction, offset),
                   part_before(p, t_mesh.parts, face, opposite, total - offset)});
  return all;
}

curve::Chain side_chain(const ParametrizedTMesh& t_mesh, const std::vector<HalfEdge>& side) {
  std::vector<ArcPiece> pieces;
  for (const HalfEdge h : side) {
    const std::vector<ArcPiece> directed = graph::pieces_along(t_mesh.graph, h);
    pieces.insert(pieces.end(), directed.begin(), directed.end());
  }
  return curve::Chain(t_mesh.table, pieces);
}

/// A node on an iso-line, and the line's parameter in [0, 1] there.
struct LineNode {
  double t = 0;
  Vec2 position;
};

// A spline through all nodes of an iso-line and points between them; it replaces the line from here on.
Nurbs spline_through(const std::vector<LineNode>& nodes, const std::function<Vec2(double)>& position) {
  std::vector<double> t;
  std::vector<Vec2> x;
  for (size_t k = 0; k < nodes.size(); ++k) {
    t.push_back(nodes[k].t);
    x.push_back(nodes[k].position);
    if (k + 1 == nodes.size()) break;
    for (int i = 1; i < samples_between; ++i) {
      t.push_back(nodes[k].t + (nodes[k + 1].t - nodes[k].t) * i / samples_between);
      x.push_back(position(t.back()));
    }
  }
  const double h = 1e-4;
  const Vec2 d0 = (-3 * x.front() + 4 * position(h) - position(2 * h)) / (2 * h);
  const Vec2 d1 = (3 * x.back() - 4 * position(1 - h) + position(1 - 2 * h)) / (2 * h);
  return curve::cubic_spline(t, x, d0, d1);
}

std::vector<LineNode> with_ends(const graph::Subdivision& subdivision, const StraightLine& line,
                                const std::vector<LineNode>& inside) {
  const auto end_position = [&](HalfEdge h) { return subdivision.graph().nodes[subdivision.end(h)].position; };
  std::vector<LineNode> nodes{{0, end_position(line.from)}};
  nodes.insert(nodes.end(), inside.begin(), inside.end());
  nodes.push_back({1, end_position(line.to)});
  return nodes;
}

void record_line(const StraightLine& line, const std::vector<HalfEdge>& parts, graph::CandidateLayout& layout) {
  SeparatrixLine record{layout.subdivision.end(line.from), layout.subdivision.end(line.to), LineKind::extended, {}};
  for (const HalfEdge h : parts) record.arcs.push_back(h.arc);
  layout.lines.push_back(std::move(record));
}

// Divides a face by a line of direction 0 on `curve`, and the line at its nodes. Returns the line's parts.
std::vector<HalfEdge> insert_line(graph::Subdivision& subdivision, const StraightLine& line,
                                  const std::vector<LineNode>& nodes, int curve) {
  std::vector<HalfEdge> parts{subdivision.insert_arc({line.from}, {line.to}, {{curve, 0, 1}})};
  for (size_t k = 1; k + 1 < nodes.size(); ++k) {
    const graph::Subdivision::Division divided =
        subdivision.divide_arc(parts.back(), {nodes[k].position, NodeKind::crossing, 4, -1, 0},
                               {{curve, nodes[k - 1].t, nodes[k].t}}, {{curve, nodes[k].t, 1}});
    parts.back() = divided.first;
    parts.push_back(divided.second);
  }
  return parts;
}

// Divides the faces between lines of direction 0 by a line of direction 1: the one of number j, after those before it.
std::vector<HalfEdge> insert_across(graph::Subdivision& subdivision, const StraightLine& line, size_t j,
                                    const std::vector<LineNode>& nodes, int curve,
                                    const std::vector<std::vector<HalfEdge>>& crossed) {
  std::vector<HalfEdge> parts;
  HalfEdge from = line.from;
  for (size_t k = 0; k + 1 < nodes.size(); ++k) {
    const bool is_last = k == crossed.size();
    const HalfEdge to = is_last ? line.to : crossed[crossed.size() - 1 - k][j + 1].reversed();
    parts.push_back(subdivision.insert_arc({from}, {to}, {{curve, nodes[k].t, nodes[k + 1].t}}));
    if (!is_last) from = crossed[crossed.size() - 1 - k][j];
  }
  return parts;
}

}  // namespace

// Direction 0 runs from side 0 (t = 0) to side 2, at s from start to end; direction 1 from side 1 (s = 1) to side 3.
void draw_iso_lines(const ParametrizedTMesh& t_mesh, int face, graph::CandidateLayout& layout) {
  const std::array lines{straight_lines(t_mesh, face, 0), straight_lines(t_mesh, face, 1)};
  if (lines[0].empty() && lines[1].empty()) return;
  const TFace& sides = t_mesh.parametrization.sides().faces()[face];
  const std::array chains{side_chain(t_mesh, sides[0]), side_chain(t_mesh, sides[1]), side_chain(t_mesh, sides[2]),
                          side_chain(t_mesh, sides[3])};
  const mesh::TransfiniteMap map({&chains[0], &chains[1], &chains[2], &chains[3]}, {false, false, false, false});
  const auto crossing = [](const StraightLine& a, const StraightLine& b) {
    return mesh::crossing_parameters(a.start, b.start, a.end, b.end);
  };
  graph::Subdivision& subdivision = layout.subdivision;
  std::vector<std::vector<HalfEdge>> drawn;
  for (const StraightLine& a : lines[0]) {
    std::vector<LineNode> nodes;
    for (const StraightLine& b : lines[1]) {
      const Vec2 st = crossing(a, b);
      nodes.push_back({st.y, map.position(st.x, st.y)});
    }
    nodes = with_ends(subdivision, a, nodes);
    const int curve = subdivision.add_spline(
        spline_through(nodes, [&](double t) { return map.position(a.start + t * (a.end - a.start), t); }));
    drawn.push_back(insert_line(subdivision, a, nodes, curve));
    record_line(a, drawn.back(), layout);
  }
  for (size_t j = 0; j < lines[1].size(); ++j) {
    const StraightLine& b = lines[1][j];
    std::vector<LineNode> nodes;
    for (size_t i = lines[0].size(); i-- > 0;) {
      const Vec2 st = crossing(lines[0][i], b);
      nodes.push_back({1 - st.x, map.position(st.x, st.y)});
    }
    nodes = with_ends(subdivision, b, nodes);
    const int curve = subdivision.add_spline(
        spline_through(nodes, [&](double r) { return map.position(1 - r, b.start + r * (b.end - b.start)); }));
    record_line(b, insert_across(subdivision, b, j, nodes, curve, drawn), layout);
  }
}

}  // namespace quadrille::quantize
