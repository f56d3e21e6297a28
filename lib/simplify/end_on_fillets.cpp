#include "simplify/end_on_fillets.hpp"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <utility>

#include "curve/nurbs.hpp"
#include "graph/arc_pieces.hpp"
#include "graph/separatrix_lines.hpp"
#include "simplify/block_quality.hpp"
#include "simplify/chord_blend.hpp"

namespace quadrille::simplify {
namespace {

using graph::Pieces;
using graph::Subdivision;

constexpr double relative_fit_tol = 2e-9;  // relative to the diameter, as for traced lines
constexpr double equal_lengths = 1e-6;     // relative to the diameter
constexpr double least_gain = 0.01;        // of the scaled Jacobian: less is not worth a line that leaves the field

// The end of one line that would move to one fillet.
struct EndMove {
  FilletMiddle to;
  Vec2 position;
  int node = -1;
  HalfEdge line;                    // ends at the node
  int shortened = -1, longer = -1;  // boundary arcs at the node: the one with the fillet, the other
  Pieces left, gained;              // of the shortened arc: what it keeps, what the other gets
  bool is_forwards = true;          // along the boundary
  double length = 0;
  double gain = 0;  // of the worst block beside it, if it is moved alone
  double deviation = 0;
};

double length_of(const ArcGraph& graph, const Pieces& pieces) {
  const curve::CurveTable table(graph.face, graph.splines);
  return curve::Chain(table, pieces).length();
}

// The move of the end at a node of the arc that holds the fillet, if a regular line ends there.
std::optional<EndMove> end_move(const Subdivision& subdivision, int arc, const curve::ChainPoint& at,
                                const FilletMiddle& fillet, bool is_forwards) {
  const ArcGraph& graph = subdivision.graph();
  const int n = is_forwards ? graph.arcs[arc].from : graph.arcs[arc].to;
  const GraphNode& node = graph.nodes[n];
  const std::vector<HalfEdge> around = subdivision.around(n);
  if (node.kind != NodeKind::boundary || node.valence != 2 || around.size() != 3) return std::nullopt;
  const int other = is_forwards ? around[2].arc : around[0].arc;
  if (other == arc || !graph.arcs[other].is_boundary || graph.arcs[around[1].arc].is_boundary) return std::nullopt;
  EndMove move{fillet, at.position, n, around[1].reversed(), arc, other, {}, {}, is_forwards, 0, 0, 0};
  if (graph.nodes[subdivision.start(move.line)].curve >= 0) return std::nullopt;  // from the boundary to the boundary
  auto [before, behind] = graph::cut(graph.arcs[arc].pieces, at);
  move.gained = is_forwards ? before : behind;
  move.left = is_forwards ? behind : before;
  move.length = length_of(graph, move.gained);
  return move;
}

// The two moves to a fillet at most.
std::vector<EndMove> moves_to(const Subdivision& subdivision, const FilletMiddle& fillet) {
  const ArcGraph& graph = subdivision.graph();
  std::vector<EndMove> moves;
  for (int a = 0; a < subdivision.arc_bound(); ++a) {
    if (!subdivision.has_arc(a) || !graph.arcs[a].is_boundary) continue;
    const Pieces& pieces = graph.arcs[a].pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].curve != fillet.curve || fillet.t < pieces[i].t0 || fillet.t >= pieces[i].t1) continue;
      if (i == 0 && fillet.t == pieces[i].t0) return {};  // a line ends there already
      const Nurbs& curve = graph.face.curves[fillet.curve];
      const curve::ChainPoint at{curve::point(curve, fillet.t), curve::tangent(curve, fillet.t), static_cast<int>(i),
                                 fillet.t};
      for (const bool is_forwards : {true, false})
        if (auto move = end_move(subdivision, a, at, fillet, is_forwards)) moves.push_back(std::move(*move));
      return moves;
    }
  }
  return moves;
}

// The line of a move: it begins as before and ends along the normal at the fillet.
Nurbs moved_line(const field::FieldEvaluator& evaluator, const ArcGraph& graph, EndMove& move) {
  const curve::CurveTable table(graph.face, graph.splines);
  const curve::Chain now(table, graph::pieces_along(graph, move.line));
  const Vec2 inward = left_of(curve::tangent(graph.face.curves[move.to.curve], move.to.t));
  const std::vector<Nurbs> normal{curve::segment(move.position + now.length() * inward, move.position)};
  const curve::CurveTable normals(graph.face, normal);
  const curve::Chain end(normals, {{graph.face.num_curves(), normal[0].begin(), normal[0].end()}});
  move.deviation = deviation_of_blend(evaluator, now, end);
  return curve::fit_line(blended_curve(now, end), blend_length(now, end), relative_fit_tol * graph.face.diameter);
}

void apply(const field::FieldEvaluator& evaluator, Subdivision& subdivision, EndMove& move) {
  const ArcGraph& graph = subdivision.graph();
  Nurbs line = moved_line(evaluator, graph, move);
  const double begin = line.begin(), end = line.end();
  const Pieces& other = graph.arcs[move.longer].pieces;
  Pieces longer = move.is_forwards ? graph::joined(other, move.gained) : graph::joined(move.gained, other);
  subdivision.set_pieces(move.longer, std::move(longer));
  subdivision.set_pieces(move.shortened, move.left);
  const int curve = subdivision.add_spline(std::move(line));
  subdivision.reshape_arc(move.line, {{curve, begin, end}});
  subdivision.move_boundary_node(move.node, move.position, move.to.curve, move.to.t);
}

std::set<int> arcs_of(const std::vector<EndMove>& moves) {
  std::set<int> arcs;
  for (const EndMove& move : moves) arcs.insert({move.line.arc, move.shortened, move.longer});
  return arcs;
}

// How much better the worst block beside the moves becomes; negative if blocks become invalid. Moves them if `keep`.
double gain_of(const field::FieldEvaluator& evaluator, Subdivision& subdivision, std::vector<EndMove>& moves,
               bool keep) {
  const std::vector<int> faces = faces_beside(subdivision, arcs_of(moves));
  BlockQuads quads, before_quads;
  const double before = worst_quality(subdivision, faces, before_quads).least_scaled_jacobian;
  subdivision.begin_trial();
  for (EndMove& move : moves) apply(evaluator, subdivision, move);
  double gain = worst_quality(subdivision, faces, quads).least_scaled_jacobian - before;
  if (gain > 0 && !are_valid(quads)) gain = -1;
  if (keep && gain >= least_gain)
    subdivision.keep_trial();
  else
    subdivision.undo_trial();
  return gain;
}

// The better one of two ends, if it is worth it. Of two that are equal none is better.
std::optional<EndMove> best_move(const field::FieldEvaluator& evaluator, Subdivision& subdivision,
                                 const FilletMiddle& fillet) {
  std::optional<EndMove> best;
  bool is_equal = false;
  for (EndMove& move : moves_to(subdivision, fillet)) {
    std::vector<EndMove> alone{move};
    alone[0].gain = gain_of(evaluator, subdivision, alone, false);
    is_equal = best && std::abs(alone[0].gain - best->gain) <= equal_lengths;
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

FilletEnds end_lines_on_fillets(const field::FieldEvaluator& evaluator, const std::vector<FilletMiddle>& fillets,
                                graph::CandidateLayout& layout) {
  FilletEnds ends;
  if (fillets.empty()) return ends;
  Subdivision& subdivision = layout.subdivision;
  std::vector<LineKind> kinds = graph::spline_kinds(layout.graph(), layout.lines);
  std::vector<FilletMiddle> left = fillets;
  while (!left.empty()) {
    std::vector<EndMove> moves;
    for (const FilletMiddle& fillet : left)
      if (auto move = best_move(evaluator, subdivision, fillet)) moves.push_back(std::move(*move));
    if (moves.empty()) break;
    moves = nearest_moves(std::move(moves), equal_lengths * layout.graph().face.diameter);
    if (!are_in_conflict(moves) && gain_of(evaluator, subdivision, moves, true) >= least_gain) {
      ends.num_moved += static_cast<int>(moves.size());
      for (const EndMove& move : moves) ends.deviation = std::max(ends.deviation, move.deviation);
    }
    std::erase_if(left, [&](const FilletMiddle& fillet) {
      return std::any_of(moves.begin(), moves.end(),
                         [&](const EndMove& move) { return move.to.curve == fillet.curve && move.to.t == fillet.t; });
    });
  }
  if (ends.num_moved > 0) {
    kinds.resize(layout.graph().splines.size(), LineKind::merged);  // the new ones are blends
    layout.lines = graph::lines_of_arcs(layout.graph(), kinds);
    subdivision.drop_unused_splines();
  }
  return ends;
}

}  // namespace quadrille::simplify
