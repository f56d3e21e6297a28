#include "couple/side_pairs.hpp"

#include <limits>
#include <optional>
#include <utility>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "base/tolerance.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "graph/candidate_layout.hpp"
#include "model/periodic.hpp"
#include "simplify/line_ends.hpp"

namespace quadrille::couple {
namespace {

using CurvePair = std::array<int, 2>;  // opposite curves of the first and the second side

/// Joins pairs of curves that continue each other on both sides: first those that begin where no other ends, then
/// closed ones. `lengths`: of the curves of the face.
std::vector<SidePair> chains_of(const CadFace& face, const curve::CurveTable& lengths,
                                const std::vector<CurvePair>& pairs) {
  std::vector<int> second_of(face.num_curves(), -1);  // by curve of a first side
  for (const auto& [first, second] : pairs) second_of[first] = second;
  const auto continues = [&](int curve) {
    const int next = face.next_in_loop(curve);
    return second_of[curve] >= 0 && second_of[next] >= 0 && face.next_in_loop(second_of[next]) == second_of[curve];
  };
  std::vector<bool> is_used(face.num_curves(), false);
  std::vector<SidePair> chains;
  for (const bool is_closed : {false, true})
    for (const CurvePair& pair : pairs) {
      if (is_used[pair[0]] || (!is_closed && continues(face.previous_in_loop(pair[0])))) continue;
      SidePair& chain = chains.emplace_back();
      chain.is_closed = is_closed;
      chain.offsets.push_back(0);
      for (int curve = pair[0]; !is_used[curve]; curve = face.next_in_loop(curve)) {
        chain.curves[0].push_back(curve);
        chain.curves[1].push_back(second_of[curve]);
        chain.offsets.push_back(chain.offsets.back() + lengths.arc_length(curve).total());
        is_used[curve] = true;
        if (!continues(curve)) break;
      }
    }
  return chains;
}

int index_of(const std::vector<int>& curves, int curve) {
  const auto found = std::find(curves.begin(), curves.end(), curve);
  return found == curves.end() ? -1 : static_cast<int>(found - curves.begin());
}

/// Adds the nodes of one layout to the sides on which they lie. `lengths`: of the curves of the whole.
void add_nodes(const RegionLayouts& layouts, int number, const curve::CurveTable& lengths, CutEnds cuts,
               std::vector<SidePair>& pairs) {
  const graph::CandidateLayout& layout = layouts.layouts[number];
  const ArcGraph& graph = layout.graph();
  const curve::CurveTable table(graph.face, graph.splines);
  const std::vector<LineKind> kinds = graph::spline_kinds(graph, layout.lines);
  const auto side_node = [&](int node, double position) {
    SideNode found{number, node, position};
    const int line = simplify::line_ending_at(layout.subdivision, node);
    if (line < 0) return found;
    const int spline = graph.arcs[line].pieces.front().curve - graph.face.num_curves();
    found.is_movable = true;
    found.line_length = curve::Chain(table, graph.arcs[line].pieces).length();
    found.is_cut = spline >= 0 && kinds[spline] == LineKind::cut;
    return found;
  };
  for (SidePair& pair : pairs)
    for (int n = 0; n < static_cast<int>(graph.nodes.size()); ++n) {
      if (graph.nodes[n].curve < 0) continue;
      const BoundaryPoint point = layouts.point_of(number, n);
      for (const int side : {0, 1}) {
        const int k = index_of(pair.curves[side], point.curve);
        if (k < 0) continue;
        const int first = pair.curves[0][k];
        const double t = point.curve == first ? point.t : periodic_parameter(layouts.face, point.curve, point.t, first);
        double position = pair.offsets[k] + lengths.arc_length(first).at(t);
        if (!pair.is_closed && (position <= 0 || position >= pair.length())) continue;
        if (position >= pair.length()) position = 0;
        const SideNode node = side_node(n, position);
        if (!node.is_cut || cuts == CutEnds::included) pair.nodes[side].push_back(node);
      }
    }
}

std::vector<SidePair> sides(const RegionLayouts& layouts, const std::vector<CurvePair>& pairs, CutEnds cuts) {
  const std::vector<Nurbs> no_splines;
  const curve::CurveTable lengths(layouts.face, no_splines);
  std::vector<SidePair> chains = chains_of(layouts.face, lengths, pairs);
  for (int r = 0; r < static_cast<int>(layouts.layouts.size()) && !chains.empty(); ++r)
    add_nodes(layouts, r, lengths, cuts, chains);
  for (SidePair& chain : chains)
    for (std::vector<SideNode>& side : chain.nodes)
      std::stable_sort(side.begin(), side.end(),
                       [](const SideNode& a, const SideNode& b) { return a.position < b.position; });
  return chains;
}

constexpr double greatest_fraction = 1.0 / 3;  // of the distance to the next end on either side

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
    if (best.node >= 0 && std::abs(d - best.distance) <= tolerance::tied * best.distance) {
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

// The move to the point, on the boundary arc beside the node that contains it.
std::optional<simplify::LineEndMove> move_to(const graph::CandidateLayout& layout, int node,
                                             const BoundaryPoint& point) {
  const std::vector<HalfEdge> around = layout.subdivision.around(node);
  for (const bool is_forwards : {true, false}) {
    const int arc = is_forwards ? around.front().arc : around.back().arc;
    if (auto move = simplify::line_end_move(layout.subdivision, arc, point.curve, point.t, is_forwards)) return move;
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
  largest = std::max(largest, degrees(simplify::move_line_end(layout.subdivision, *move, field)));
}

void move_both(RegionLayouts& layouts, const SidePair& pair, const NodeMatch& match) {
  const std::array<const SideNode*, 2> nodes{&pair.nodes[0][match.nodes[0]], &pair.nodes[1][match.nodes[1]]};
  const auto fixed = std::find_if(nodes.begin(), nodes.end(), [](const SideNode* n) { return !n->is_movable; });
  const BoundaryPoint point = fixed != nodes.end() ? layouts.point_of((*fixed)->layout, (*fixed)->node)
                                                   : point_at(layouts.face, pair, match.position);
  for (const int side : {0, 1}) move_line_end(layouts, *nodes[side], point_on_side(layouts.face, pair, side, point));
}

}  // namespace

std::vector<SidePair> interface_sides(const RegionLayouts& regions, CutEnds cuts) {
  const CadFace& face = regions.face;
  std::vector<CurvePair> pairs;
  for (int c = 0; c < face.num_curves(); ++c)
    if (face.is_interface(c) && c < face.partners[c]) pairs.push_back({c, face.partners[c]});
  return sides(regions, pairs, cuts);
}

std::vector<SidePair> periodic_sides(const RegionLayouts& layouts) {
  std::vector<CurvePair> pairs;
  for (const PeriodicPair& pair : layouts.face.periodic_pairs) pairs.push_back({pair.curves[0], pair.curves[1]});
  return sides(layouts, pairs, CutEnds::included);
}

BoundaryPoint point_on_side(const CadFace& face, const SidePair& pair, int side, const BoundaryPoint& point) {
  if (index_of(pair.curves[side], point.curve) >= 0) return point;
  const int k = index_of(pair.curves[1 - side], point.curve);
  if (k < 0) throw Defect("couple: a point that is on neither of two sides has none opposite to it");
  return opposite_point(face, point, pair.curves[side][k]);
}

BoundaryPoint point_at(const CadFace& face, const SidePair& pair, double position) {
  std::size_t k = 0;
  while (k + 1 < pair.curves[0].size() && position >= pair.offsets[k + 1]) ++k;
  const int curve = pair.curves[0][k];
  return boundary_point(face, curve, curve::ArcLength(face.curves[curve]).parameter(position - pair.offsets[k]));
}

std::vector<NodeMatch> matches_of_neighbours(const SidePair& pair, double diameter, double most_bend) {
  std::vector<NodeMatch> matches;
  const double coincident = tolerance::round_off * diameter;
  for (int a = 0; a < static_cast<int>(pair.nodes[0].size()); ++a) {
    const SideNode& lower = pair.nodes[0][a];
    const Nearest across = nearest(pair, 1, lower.position);
    if (across.node < 0 || across.is_tied || across.distance <= coincident) continue;
    const SideNode& other = pair.nodes[1][across.node];
    const Nearest back = nearest(pair, 0, other.position);
    if (back.node != a || back.is_tied || (!lower.is_movable && !other.is_movable)) continue;
    const double clearance = std::min(spacing(pair, 0, a), spacing(pair, 1, across.node));
    if (across.distance >= greatest_fraction * clearance && bend(lower, other, across.distance) > most_bend) continue;
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

int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, const MatchRule& rule) {
  if (pairs.empty()) return 0;
  std::vector<std::vector<LineKind>> kinds = layouts.line_kinds();
  int num_matches = 0;
  for (const SidePair& pair : pairs)
    for (const NodeMatch& match : rule(pair)) {
      move_both(layouts, pair, match);
      ++num_matches;
    }
  layouts.rebuild_lines(std::move(kinds), LineKind::merged);
  return num_matches;
}

int match_line_ends(RegionLayouts& layouts, const std::vector<SidePair>& pairs, double most_bend) {
  const double diameter = layouts.face.diameter;
  return match_line_ends(layouts, pairs,
                         [&](const SidePair& pair) { return matches_of_neighbours(pair, diameter, most_bend); });
}

}  // namespace quadrille::couple
