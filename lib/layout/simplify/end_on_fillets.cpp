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
#include "simplify/line_end_move.hpp"

namespace quadrille::simplify {
namespace {

using graph::Pieces;
using graph::Subdivision;

constexpr double equal_lengths = 1e-6;  // relative to the diameter
constexpr double least_gain = 0.01;     // of the scaled Jacobian: less is not worth a line that leaves the field

// The end of one line that would move to one fillet.
struct EndMove : LineEndMove {
  double gain = 0;  // of the worst block beside it, if it is moved alone
  double deviation = 0;
};

// The move of the end at a node of the arc that contains the fillet, if a regular line from inside ends there.
std::optional<EndMove> end_move(const Subdivision& subdivision, int arc, const curve::ChainPoint& at,
                                bool is_forwards) {
  std::optional<LineEndMove> move = line_end_move(subdivision, arc, at, is_forwards);
  if (!move || subdivision.graph().nodes[move->node].kind != NodeKind::boundary) return std::nullopt;
  if (subdivision.graph().nodes[subdivision.start(move->line)].curve >= 0) return std::nullopt;
  return EndMove{std::move(*move), 0, 0};
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
        if (auto move = end_move(subdivision, a, at, is_forwards)) moves.push_back(std::move(*move));
      return moves;
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
  for (EndMove& move : moves) move.deviation = move_line_end(subdivision, move, &fields);
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
    moves = nearest_moves(std::move(moves), equal_lengths * layout.graph().face.diameter);
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
