#include "simplify/line_ends.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "simplify/block_quality.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {
namespace {

double length_of(const ArcGraph& graph, const graph::Pieces& pieces) {
  const curve::CurveTable table(graph.face, graph.splines);
  return curve::Chain(table, pieces).length();
}

// The line of a move, and its deviation: it begins as before and ends along the normal at its new end.
std::pair<Nurbs, double> moved_line(const ArcGraph& graph, const LineEndMove& move,
                                    const field::FieldsOfRegions& fields) {
  const curve::CurveTable table(graph.face, graph.splines);
  const curve::Chain now(table, graph::pieces_along(graph, move.line));
  const Vec2 inward = left_of(curve::tangent(graph.face.curves[move.curve], move.t));
  const std::vector<Nurbs> normal{curve::segment(move.position + now.length() * inward, move.position)};
  const curve::CurveTable normals(graph.face, normal);
  const curve::Chain end(normals, {{graph.face.num_curves(), normal[0].begin(), normal[0].end()}});
  const double deviation = deviation_of_blend(fields, now, end);
  return {
      curve::fit_line(blended_curve(now, end), blend_length(now, end), graph::relative_fit_tol * graph.face.diameter),
      deviation};
}

using graph::Pieces;
using graph::Subdivision;

constexpr double least_gain = 0.01;  // of the scaled Jacobian: less is not worth a line that leaves the field

// The end of one line that would move to one fillet.
struct EndMove : LineEndMove {
  double gain = 0;  // of the worst block beside it, if it is moved alone
  double deviation = 0;
};

// The two moves to a fillet at most, of regular lines from inside.
std::vector<EndMove> moves_to(const Subdivision& subdivision, const FilletMiddle& fillet) {
  const ArcGraph& graph = subdivision.graph();
  std::vector<EndMove> moves;
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    if (!subdivision.has_arc(a) || !graph.arcs[a].is_boundary) continue;
    for (const bool is_forwards : {true, false}) {
      std::optional<LineEndMove> move = line_end_move(subdivision, a, fillet.curve, fillet.t, is_forwards);
      if (move && graph.nodes[move->node].kind == NodeKind::boundary &&
          graph.nodes[subdivision.start(move->line)].curve < 0)
        moves.push_back({std::move(*move), 0, 0});
    }
  }
  return moves;
}

std::set<int> arcs_of(const std::vector<EndMove>& moves) {
  std::set<int> arcs;
  for (const EndMove& move : moves) arcs.insert({move.line.arc, move.shortened, move.longer});
  return arcs;
}

// How much better the worst block beside the moves becomes; negative if blocks become invalid. Moves them if `keep`.
double gain_of(const field::FieldsOfRegions& fields, Subdivision& subdivision, std::vector<EndMove>& moves, bool keep) {
  const std::vector<int> faces = faces_beside(subdivision, arcs_of(moves));
  BlockQuads quads, before_quads;
  const double before = worst_quality(subdivision, faces, before_quads).least_scaled_jacobian;
  subdivision.begin_trial();
  for (EndMove& move : moves) move.deviation = move_line_end(subdivision, move, fields);
  double gain = worst_quality(subdivision, faces, quads).least_scaled_jacobian - before;
  if (gain > 0 && !are_valid(quads)) gain = -1;
  if (keep && gain >= least_gain)
    subdivision.keep_trial();
  else
    subdivision.undo_trial();
  return gain;
}

// The better one of two ends, if it is worth it. Of two that are equal none is better.
std::optional<EndMove> best_move(const field::FieldsOfRegions& fields, Subdivision& subdivision,
                                 const FilletMiddle& fillet) {
  std::optional<EndMove> best;
  bool is_equal = false;
  for (EndMove& move : moves_to(subdivision, fillet)) {
    std::vector<EndMove> alone{move};
    alone[0].gain = gain_of(fields, subdivision, alone, false);
    is_equal = best && std::abs(alone[0].gain - best->gain) <= tolerance::tied;
    if (!best || alone[0].gain > best->gain) best = std::move(alone[0]);
  }
  if (!best || is_equal || best->gain < least_gain) return std::nullopt;
  return best;
}

// Whether two moves concern the same end or the same part of the boundary.
bool are_in_conflict(const std::vector<EndMove>& moves) {
  std::set<int> nodes, shortened;
  for (const EndMove& move : moves)
    if (!nodes.insert(move.node).second || !shortened.insert(move.shortened).second) return true;
  return std::any_of(moves.begin(), moves.end(), [&](const EndMove& move) { return shortened.contains(move.longer); });
}

// The moves of the least equal lengths.
std::vector<EndMove> nearest_moves(std::vector<EndMove> moves, double tie) {
  std::stable_sort(moves.begin(), moves.end(), [](const EndMove& a, const EndMove& b) { return a.length < b.length; });
  const auto last = std::find_if(moves.begin(), moves.end(),
                                 [&](const EndMove& move) { return move.length > moves.front().length + tie; });
  moves.erase(last, moves.end());
  return moves;
}

}  // namespace

int line_ending_at(const Subdivision& subdivision, int node) {
  const GraphNode& n = subdivision.graph().nodes[node];
  const std::vector<HalfEdge> around = subdivision.around(node);
  const bool is_line_end = n.kind == NodeKind::boundary || n.kind == NodeKind::cut;
  return is_line_end && n.valence == 2 && around.size() == 3 ? around[1].arc : -1;
}

std::optional<LineEndMove> line_end_move(const Subdivision& subdivision, int arc, int curve, double t,
                                         bool is_forwards) {
  const ArcGraph& graph = subdivision.graph();
  const Pieces& pieces = graph.arcs[arc].pieces;
  std::size_t i = 0;
  while (i < pieces.size() && (pieces[i].curve != curve || t < pieces[i].t0 || t >= pieces[i].t1)) ++i;
  if (i == pieces.size() || (i == 0 && t == pieces[0].t0)) return std::nullopt;
  const int n = is_forwards ? graph.arcs[arc].from : graph.arcs[arc].to;
  if (line_ending_at(subdivision, n) < 0) return std::nullopt;
  const std::vector<HalfEdge> around = subdivision.around(n);
  const int other = is_forwards ? around[2].arc : around[0].arc;
  if (other == arc || !graph.arcs[other].is_boundary || graph.arcs[around[1].arc].is_boundary) return std::nullopt;
  const curve::ChainPoint at = graph::point_on_piece(graph, pieces, i, t);
  LineEndMove move{curve, t, at.position, n, around[1].reversed(), arc, other, {}, {}, is_forwards, 0};
  auto [before, behind] = graph::cut(pieces, at);
  move.gained = is_forwards ? before : behind;
  move.left = is_forwards ? behind : before;
  move.length = length_of(graph, move.gained);
  return move;
}

double move_line_end(graph::Subdivision& subdivision, const LineEndMove& move, const field::FieldsOfRegions& fields) {
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

FilletEnds end_lines_on_fillets(const field::FieldsOfRegions& fields, const std::vector<FilletMiddle>& fillets,
                                graph::CandidateLayout& layout) {
  FilletEnds ends;
  if (fillets.empty()) return ends;
  Subdivision& subdivision = layout.subdivision;
  std::vector<LineKind> kinds = graph::spline_kinds(layout.graph(), layout.lines);
  std::vector<FilletMiddle> left = fillets;
  while (!left.empty()) {
    std::vector<EndMove> moves;
    for (const FilletMiddle& fillet : left)
      if (auto move = best_move(fields, subdivision, fillet)) moves.push_back(std::move(*move));
    if (moves.empty()) break;
    moves = nearest_moves(std::move(moves), tolerance::tied * layout.graph().face.diameter);
    if (!are_in_conflict(moves) && gain_of(fields, subdivision, moves, true) >= least_gain) {
      ends.num_moved += static_cast<int>(moves.size());
      for (const EndMove& move : moves) ends.deviation = std::max(ends.deviation, move.deviation);
    }
    std::erase_if(left, [&](const FilletMiddle& fillet) {
      return std::any_of(moves.begin(), moves.end(),
                         [&](const EndMove& move) { return move.curve == fillet.curve && move.t == fillet.t; });
    });
  }
  if (ends.num_moved > 0) graph::rebuild_lines(layout, std::move(kinds), LineKind::merged);  // the new ones are blends
  return ends;
}

}  // namespace quadrille::simplify
