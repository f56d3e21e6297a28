#include "mesh/periodic_arcs.hpp"

#include <fmt/format.h>

#include <algorithm>

#include "base/error.hpp"
#include "base/position_text.hpp"
#include "model/interfaces.hpp"

namespace quadrille::mesh {
namespace {

constexpr double same_position = 1e-6;  ///< diameters

Vec2 moved(const CadFace& face, const PeriodicPair& pair, Vec2 x) {
  const Vec2 p = x + face.origin, turn = unit(pair.angle);
  return Vec2{turn.x * p.x - turn.y * p.y, turn.y * p.x + turn.x * p.y} + pair.shift - face.origin;
}

/// A boundary arc with the face on its left, from its start to its end.
struct Directed {
  HalfEdge arc;
  Vec2 start, end;
};

/// The boundary arcs whose first piece lies on the curve.
std::vector<Directed> arcs_on(const ArcGraph& graph, int curve) {
  std::vector<Directed> found;
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    const GraphArc& arc = graph.arcs[a];
    const auto is_on_curve = [&](const ArcPiece& piece) { return piece.curve == curve; };
    if (!arc.is_boundary || std::none_of(arc.pieces.begin(), arc.pieces.end(), is_on_curve)) continue;
    const HalfEdge h{a, arc.pieces.front().t0 > arc.pieces.front().t1};
    found.push_back({h, graph.nodes[start_of(graph.arcs, h)].position, graph.nodes[end_of(graph.arcs, h)].position});
  }
  return found;
}

/// The arc on the second curve onto which the motion maps `first`; -1: none.
HalfEdge counterpart(const ArcGraph& graph, const PeriodicPair& pair, const Directed& first) {
  const Vec2 start = moved(graph.face, pair, first.start), end = moved(graph.face, pair, first.end);
  const double reach = same_position * graph.face.diameter;
  for (const Directed& second : arcs_on(graph, pair.curves[1]))
    if (distance(second.start, end) <= reach && distance(second.end, start) <= reach) return second.arc;
  return {};
}

/// The pairs of the face, and cracks: both sides of an open slit lie in one place.
std::vector<PeriodicPair> pairs_of_curves(const ArcGraph& graph) {
  std::vector<PeriodicPair> pairs = graph.face.periodic_pairs;
  if (graph.face.partners.empty()) return pairs;
  const std::vector<int> curve_region = curve_regions(graph.face);
  for (int c = 0; c < graph.face.num_curves(); ++c)
    if (const int partner = graph.face.partners[c]; partner > c && curve_region[c] == curve_region[partner])
      pairs.push_back({{c, partner}, 0, {}});
  return pairs;
}

}  // namespace

std::vector<PeriodicArcs> periodic_arcs(const ArcGraph& graph) {
  std::vector<PeriodicArcs> pairs;
  for (const PeriodicPair& pair : pairs_of_curves(graph))
    for (const Directed& first : arcs_on(graph, pair.curves[0]))
      if (const HalfEdge second = counterpart(graph, pair, first); second.arc >= 0)
        pairs.push_back({first.arc, second});
  std::sort(pairs.begin(), pairs.end());
  pairs.erase(std::unique(pairs.begin(), pairs.end()), pairs.end());  // an arc may follow several curves
  return pairs;
}

void require_periodic_arcs(const ArcGraph& graph) {
  if (graph.face.periodic_pairs.empty()) return;
  std::vector<bool> is_paired(graph.arcs.size(), false);
  for (const auto& [first, second] : periodic_arcs(graph)) is_paired[first.arc] = is_paired[second.arc] = true;
  for (const PeriodicPair& pair : graph.face.periodic_pairs)
    for (const int curve : pair.curves)
      for (const Directed& on_curve : arcs_on(graph, curve))
        if (!is_paired[on_curve.arc.arc])
          throw ComputeError(fmt::format(
              "the blocks along the periodic curves {} and {} do not match: the side from {} to {} has no counterpart",
              graph.face.curve_names[pair.curves[0]], graph.face.curve_names[pair.curves[1]],
              position_text(on_curve.start + graph.face.origin), position_text(on_curve.end + graph.face.origin)));
}

}  // namespace quadrille::mesh
