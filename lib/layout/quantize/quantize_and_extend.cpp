#include "quantize/quantize_and_extend.hpp"

#include <algorithm>
#include <array>
#include <iterator>
#include <utility>

#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/candidate_layout.hpp"
#include "graph/chord_strip.hpp"
#include "mesh/transfinite.hpp"
#include "model/periodic.hpp"

namespace quadrille::quantize {
namespace {

// From the last crossing to the first: what remains of the arc begins with the pieces of the chain.
std::vector<int> split_arc(int arc, const curve::Chain& chain, const std::map<int, double>& fractions,
                           graph::Subdivision& subdivision) {
  std::vector<int> parts;
  for (auto crossing = fractions.rbegin(); crossing != fractions.rend(); ++crossing)
    parts.push_back(graph::divide_at_point(subdivision, {arc}, chain.at(crossing->second)).second.arc);
  parts.push_back(arc);
  std::reverse(parts.begin(), parts.end());
  return parts;
}

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

std::vector<SeparatrixLine> split_lines(std::vector<SeparatrixLine> lines, const ArcParts& parts) {
  for (SeparatrixLine& line : lines) {
    std::vector<int> arcs;
    for (const int a : line.arcs) arcs.insert(arcs.end(), parts[a].begin(), parts[a].end());
    line.arcs = std::move(arcs);
  }
  return lines;
}

constexpr double relative_unit = 0.1;  // an arc of this length, relative to the diameter, has integer length one

/// The faces of a T-mesh, and what is known of their integer grids.
struct QuantizedFaces {
  std::vector<HalfEdge> same;  // of periodic arcs (model/periodic.hpp, first_arcs); empty: none are glued
  std::vector<TFace> faces, glued;
  Quantization found;
};

QuantizedFaces quantized_faces(const graph::CandidateLayout& t_mesh, PeriodicSides sides, Progress* progress) {
  const Progress::Part part(progress, "integer program");
  const ArcGraph& graph = t_mesh.graph();
  QuantizedFaces q;
  if (sides == PeriodicSides::glued) q.same = first_arcs(graph);
  q.faces = t_mesh_faces(t_mesh.subdivision);
  q.glued = faces_across_periodic_sides(q.faces, q.same);
  q.found = quantize_or_explain(q.glued, graph::arc_lengths(graph), relative_unit * graph.face.diameter);
  std::vector<int>& lengths = q.found.lengths;
  for (std::size_t a = 0; a < lengths.size() && !q.same.empty(); ++a) lengths[a] = lengths[q.same[a].arc];
  return q;
}

}  // namespace

ArcParts split_arcs(const std::vector<curve::Chain>& chains, const CrossingFractions& fractions,
                    graph::Subdivision& subdivision) {
  ArcParts parts;
  for (size_t a = 0; a < chains.size(); ++a)
    parts.push_back(split_arc(static_cast<int>(a), chains[a], fractions[a], subdivision));
  return parts;
}

HalfEdge part_before(const QuantizedParametrization& parametrization, const ArcParts& parts, int face, int side,
                     int position) {
  const auto [h, number] = parametrization.sides().half_edge_at(face, side, position);
  const std::map<int, double>& crossings = parametrization.crossing_fractions()[h.arc];
  const auto next = h.is_backwards ? crossings.upper_bound(parametrization.sides().arc(h.arc) - number)
                                   : crossings.lower_bound(number);
  return {parts[h.arc][std::distance(crossings.begin(), next)], h.is_backwards};
}

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

graph::CandidateLayout extend_lines(const graph::CandidateLayout& layout, const std::vector<TFace>& faces,
                                    const std::vector<int>& lengths, const std::vector<HalfEdge>& same) {
  const ArcGraph& t_mesh = layout.graph();
  const curve::CurveTable table(t_mesh.face, t_mesh.splines);
  std::vector<curve::Chain> chains;
  std::vector<double> arc_lengths;
  for (const GraphArc& arc : t_mesh.arcs) {
    chains.emplace_back(table, arc.pieces);
    arc_lengths.push_back(chains.back().length());
  }
  const QuantizedParametrization parametrization(t_mesh, faces, lengths, std::move(arc_lengths), same);
  graph::CandidateLayout extended = layout;
  const ArcParts parts = split_arcs(chains, parametrization.crossing_fractions(), extended.subdivision);
  extended.lines = split_lines(layout.lines, parts);
  extended.t_junctions.clear();
  for (int f = 0; f < static_cast<int>(faces.size()); ++f)
    draw_iso_lines({t_mesh, table, parametrization, parts}, f, extended);
  extended.subdivision.compact();
  graph::require_four_corners(extended.subdivision);
  graph::require_drawn_in_order(extended.subdivision);
  return extended;
}

std::vector<int> InfeasibleTMesh::zero_arcs() const {
  return forced_zero_arcs(faces, static_cast<int>(t_mesh.graph().arcs.size()));
}

ExtendedTMesh quantize_and_extend(graph::CandidateLayout t_mesh, PeriodicSides sides, const ReplaceTMesh& replace,
                                  Progress* progress) {
  QuantizedFaces q = quantized_faces(t_mesh, sides, progress);
  while (q.found.lengths.empty()) {
    t_mesh = replace({t_mesh, q.glued, q.found.strips});
    q = quantized_faces(t_mesh, sides, progress);
  }
  const Progress::Part part(progress, "continued lines");
  const std::vector<int>& lengths = q.found.lengths;
  return {extend_lines(t_mesh, q.faces, lengths, q.same), *std::max_element(lengths.begin(), lengths.end())};
}

}  // namespace quadrille::quantize
