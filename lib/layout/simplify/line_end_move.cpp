#include "simplify/line_end_move.hpp"

#include <utility>
#include <vector>

#include "curve/nurbs.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {
namespace {

constexpr double relative_fit_tol = 2e-9;  // relative to the diameter, as for traced lines

double length_of(const ArcGraph& graph, const graph::Pieces& pieces) {
  const curve::CurveTable table(graph.face, graph.splines);
  return curve::Chain(table, pieces).length();
}

// The line of a move, and its deviation: it begins as before and ends along the normal at its new end.
std::pair<Nurbs, double> moved_line(const ArcGraph& graph, const LineEndMove& move,
                                    const field::FieldsOfRegions* fields) {
  const curve::CurveTable table(graph.face, graph.splines);
  const curve::Chain now(table, graph::pieces_along(graph, move.line));
  const Vec2 inward = left_of(curve::tangent(graph.face.curves[move.curve], move.t));
  const std::vector<Nurbs> normal{curve::segment(move.position + now.length() * inward, move.position)};
  const curve::CurveTable normals(graph.face, normal);
  const curve::Chain end(normals, {{graph.face.num_curves(), normal[0].begin(), normal[0].end()}});
  const double deviation = fields != nullptr ? deviation_of_blend(*fields, now, end) : 0;
  return {curve::fit_line(blended_curve(now, end), blend_length(now, end), relative_fit_tol * graph.face.diameter),
          deviation};
}

}  // namespace

std::optional<LineEndMove> line_end_move(const graph::Subdivision& subdivision, int arc, const curve::ChainPoint& at,
                                         bool is_forwards) {
  const ArcGraph& graph = subdivision.graph();
  const int n = is_forwards ? graph.arcs[arc].from : graph.arcs[arc].to;
  const GraphNode& node = graph.nodes[n];
  const std::vector<HalfEdge> around = subdivision.around(n);
  const bool is_line_end = node.kind == NodeKind::boundary || node.kind == NodeKind::cut;
  if (!is_line_end || node.valence != 2 || around.size() != 3) return std::nullopt;
  const int other = is_forwards ? around[2].arc : around[0].arc;
  if (other == arc || !graph.arcs[other].is_boundary || graph.arcs[around[1].arc].is_boundary) return std::nullopt;
  const graph::Pieces& pieces = graph.arcs[arc].pieces;
  LineEndMove move{
      pieces[at.piece].curve, at.t, at.position, n, around[1].reversed(), arc, other, {}, {}, is_forwards, 0};
  auto [before, behind] = graph::cut(pieces, at);
  move.gained = is_forwards ? before : behind;
  move.left = is_forwards ? behind : before;
  move.length = length_of(graph, move.gained);
  return move;
}

double move_line_end(graph::Subdivision& subdivision, const LineEndMove& move, const field::FieldsOfRegions* fields) {
  const ArcGraph& graph = subdivision.graph();
  auto [line, deviation] = moved_line(graph, move, fields);
  const double begin = line.begin(), end = line.end();
  const graph::Pieces& other = graph.arcs[move.longer].pieces;
  graph::Pieces longer = move.is_forwards ? graph::joined(other, move.gained) : graph::joined(move.gained, other);
  subdivision.set_pieces(move.longer, std::move(longer));
  subdivision.set_pieces(move.shortened, move.left);
  const int curve = subdivision.add_spline(std::move(line));
  subdivision.reshape_arc(move.line, {{curve, begin, end}});
  subdivision.move_boundary_node(move.node, move.position, move.curve, move.t);
  return deviation;
}

}  // namespace quadrille::simplify
