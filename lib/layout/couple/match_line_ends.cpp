#include "couple/match_line_ends.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "graph/separatrix_lines.hpp"
#include "simplify/line_end_move.hpp"

namespace quadrille::couple {
namespace {

constexpr double greatest_fraction = 1.0 / 3;  // of the distance to the next end on either side
constexpr double relative_coincident = 1e-9;   // relative to the diameter: ends nearer than this need not move

/// The nearest node to a position.
struct Nearest {
  int node = -1;
  double distance = std::numeric_limits<double>::infinity();
  bool is_tied = false;
};

Nearest nearest(const SidePair& pair, int side, double position, int except = -1) {
  Nearest best;
  const std::vector<SideNode>& nodes = pair.nodes[side];
  for (int i = 0; i < static_cast<int>(nodes.size()); ++i) {
    if (i == except) continue;
    const double d = pair.distance(nodes[i].position, position);
    if (best.node >= 0 && std::abs(d - best.distance) <= relative_tie * best.distance) {
      best.is_tied = true;
      continue;
    }
    if (d < best.distance) best.is_tied = false;
    if (d < best.distance) best.node = i, best.distance = d;
  }
  return best;
}

// Distance to the next end on the same side, or to the end of the chain.
double spacing(const SidePair& pair, int side, int node) {
  const double position = pair.nodes[side][node].position;
  double d = nearest(pair, side, position, node).distance;
  if (!pair.is_closed) d = std::min({d, position, pair.length() - position});
  return std::min(d, pair.length());
}

// The angle by which the more bent of two lines turns if they meet.
double bend(const SideNode& a, const SideNode& b, double distance) {
  const double moved = a.is_movable && b.is_movable ? distance / 2 : distance;
  double greatest = 0;
  for (const SideNode* s : {&a, &b})
    if (s->is_movable) greatest = std::max(greatest, moved / s->line_length);
  return greatest;
}

}  // namespace

std::vector<NodeMatch> matches_of_neighbours(const SidePair& pair, double diameter) {
  std::vector<NodeMatch> matches;
  const double coincident = relative_coincident * diameter;
  for (int a = 0; a < static_cast<int>(pair.nodes[0].size()); ++a) {
    const SideNode& lower = pair.nodes[0][a];
    const Nearest across = nearest(pair, 1, lower.position);
    if (across.node < 0 || across.is_tied || across.distance <= coincident) continue;
    const SideNode& other = pair.nodes[1][across.node];
    const Nearest back = nearest(pair, 0, other.position);
    if (back.node != a || back.is_tied || (!lower.is_movable && !other.is_movable)) continue;
    const double clearance = std::min(spacing(pair, 0, a), spacing(pair, 1, across.node));
    if (across.distance >= greatest_fraction * clearance && bend(lower, other, across.distance) > greatest_bend)
      continue;
    double middle = (lower.position + other.position) / 2;
    if (std::abs(lower.position - other.position) > pair.length() / 2)  // across the seam
      middle = middle >= pair.length() / 2 ? middle - pair.length() / 2 : middle + pair.length() / 2;
    matches.push_back({{a, across.node},
                       !lower.is_movable   ? lower.position
                       : !other.is_movable ? other.position
                                           : middle});
  }
  return matches;
}

namespace {

// The boundary arc beside the node that contains the point, and the way there.
std::optional<simplify::LineEndMove> move_to(const graph::CandidateLayout& layout, int node,
                                             const BoundaryPoint& point) {
  const std::vector<HalfEdge> around = layout.subdivision.around(node);
  const ArcGraph& graph = layout.graph();
  for (const bool is_forwards : {true, false}) {
    const int arc = is_forwards ? around.front().arc : around.back().arc;
    const std::vector<ArcPiece>& pieces = graph.arcs[arc].pieces;
    for (std::size_t i = 0; i < pieces.size(); ++i) {
      if (pieces[i].curve != point.curve || point.t < pieces[i].t0 || point.t >= pieces[i].t1) continue;
      if (i == 0 && point.t == pieces[i].t0) continue;
      const Nurbs& curve = graph.face.curves[point.curve];
      const curve::ChainPoint at{curve::point(curve, point.t), curve::tangent(curve, point.t), static_cast<int>(i),
                                 point.t};
      return simplify::line_end_move(layout.subdivision, arc, at, is_forwards);
    }
  }
  return std::nullopt;
}

void move_line_end(RegionLayouts& layouts, const SideNode& node, BoundaryPoint point) {
  if (!node.is_movable || layouts.point_of(node.layout, node.node) == point) return;
  graph::CandidateLayout& layout = layouts.layouts[node.layout];
  point.curve -= layouts.first_curves[node.layout];
  const std::optional<simplify::LineEndMove> move = move_to(layout, node.node, point);
  if (!move) return;
  const field::FieldsOfRegions field = layouts.field_of(node.layout);
  double& largest = layout.certificate.largest_deviation_degrees;
  largest = std::max(largest, degrees(simplify::move_line_end(layout.subdivision, *move, &field)));
}

void move_both(RegionLayouts& layouts, const SidePair& pair, const NodeMatch& match) {
  const std::array<const SideNode*, 2> nodes{&pair.nodes[0][match.nodes[0]], &pair.nodes[1][match.nodes[1]]};
  const auto fixed = std::find_if(nodes.begin(), nodes.end(), [](const SideNode* n) { return !n->is_movable; });
  const BoundaryPoint point = fixed != nodes.end() ? layouts.point_of((*fixed)->layout, (*fixed)->node)
                                                   : point_at(layouts.face, pair, match.position);
  for (const int side : {0, 1}) move_line_end(layouts, *nodes[side], point_on_side(layouts.face, pair, side, point));
}

}  // namespace

int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, const MatchRule& rule) {
  if (pairs.empty()) return 0;
  std::vector<std::vector<LineKind>> kinds;
  for (const graph::CandidateLayout& layout : layouts.layouts)
    kinds.push_back(graph::spline_kinds(layout.graph(), layout.lines));
  int num_matches = 0;
  for (const SidePair& pair : pairs)
    for (const NodeMatch& match : rule(pair)) {
      move_both(layouts, pair, match);
      ++num_matches;
    }
  for (std::size_t r = 0; r < kinds.size(); ++r)
    graph::rebuild_lines(layouts.layouts[r], std::move(kinds[r]), LineKind::merged);
  return num_matches;
}

int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs) {
  const double diameter = layouts.face.diameter;
  return match_line_ends(layouts, pairs, [&](const SidePair& pair) { return matches_of_neighbours(pair, diameter); });
}

}  // namespace quadrille::couple
