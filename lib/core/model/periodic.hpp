#pragma once
// Periodic sides of a face: two curves of which a motion maps the first onto the second, reversed. A solver sees them
// as one, so their nodes are images of each other, and the arcs of the one are mapped onto those of the other,
// backwards. Both sides of a crack are such curves too, with the motion that moves nothing.
//
// Arcs are compared by the parameters of their ends, not by positions: knots of both curves of a pair are mirrored.

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "base/error.hpp"
#include "base/message_text.hpp"
#include "base/vec2.hpp"
#include "model/arc_graph.hpp"
#include "model/interfaces.hpp"

namespace quadrille {

/// The motion of a pair for positions relative to `origin`.
class PeriodicMotion {
 public:
  PeriodicMotion(double angle, Vec2 shift, Vec2 origin) {
    if (angle == 0) {  // without rounding where the origin is far away
      offset_ = shift;
      return;
    }
    turn_ = unit(angle);
    offset_ = turned(origin) - origin + shift;
  }
  PeriodicMotion(const PeriodicPair& pair, Vec2 origin) : PeriodicMotion(pair.angle, pair.shift, origin) {}

  Vec2 image(Vec2 x) const { return turned(x) + offset_; }
  Vec2 original(Vec2 image) const {
    const Vec2 x = image - offset_;
    return {turn_.x * x.x + turn_.y * x.y, turn_.x * x.y - turn_.y * x.x};
  }

 private:
  Vec2 turned(Vec2 x) const { return {turn_.x * x.x - turn_.y * x.y, turn_.y * x.x + turn_.x * x.y}; }

  Vec2 turn_{1, 0}, offset_;
};

/// The other curve of the pair of each curve; -1: the curve is not periodic.
inline std::vector<int> periodic_partners(const CadFace& face) {
  std::vector<int> partners(face.curves.size(), -1);
  for (const PeriodicPair& pair : face.periodic_pairs) {
    partners[pair.curves[0]] = pair.curves[1];
    partners[pair.curves[1]] = pair.curves[0];
  }
  return partners;
}

/// The parameter of the same point on the other curve of a pair: its knots are mirrored.
inline double periodic_parameter(const CadFace& face, int curve, double t, int partner) {
  const Nurbs &own = face.curves[curve], &other = face.curves[partner];
  if (t == own.begin()) return other.end();
  if (t == own.end()) return other.begin();
  return std::clamp(other.begin() + (own.end() - t), other.begin(), other.end());
}

/// Whether two parameters of a curve are one place: nodes of both sides of a pair are images up to rounding.
inline bool is_same_parameter(const Nurbs& curve, double a, double b) {
  return std::abs(a - b) <= 1e-9 * (curve.end() - curve.begin());
}

/// Two boundary arcs, with the face on their left: the second one is the image of the first, backwards.
using PeriodicArcs = std::array<HalfEdge, 2>;

/// By curve: the second curve of the pair of which it is the first; -1.
inline std::vector<int> second_curves(const CadFace& face, const std::vector<PeriodicPair>& pairs) {
  std::vector<int> seconds(face.curves.size(), -1);
  for (const PeriodicPair& pair : pairs) seconds[pair.curves[0]] = pair.curves[1];
  return seconds;
}

/// Whether the second of two boundary arcs is the image of the first, backwards. `partners`: by curve, the one that is
/// its image.
inline bool is_image(const CadFace& face, const std::vector<int>& partners, const GraphArc& first,
                     const GraphArc& second) {
  const auto is_same = [&](const ArcPiece& of, double t_of, const ArcPiece& on, double t_on) {
    return partners[of.curve] == on.curve &&
           is_same_parameter(face.curves[on.curve], periodic_parameter(face, of.curve, t_of, on.curve), t_on);
  };
  const ArcPiece &begin = first.pieces.front(), &end = first.pieces.back();
  return is_same(end, end.t1, second.pieces.front(), second.pieces.front().t0) &&
         is_same(begin, begin.t0, second.pieces.back(), second.pieces.back().t1);
}

/// Both arcs of each pair that lies on curves of `pairs`, by the first arc. An arc without a counterpart is left out.
inline std::vector<PeriodicArcs> periodic_arcs(const ArcGraph& graph, const std::vector<PeriodicPair>& pairs) {
  if (pairs.empty()) return {};
  const std::vector<int> seconds = second_curves(graph.face, pairs);
  std::vector<std::vector<int>> starting(graph.face.curves.size());  // boundary arcs whose first piece is on the curve
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a)
    if (graph.arcs[a].is_boundary) starting[graph.arcs[a].pieces.front().curve].push_back(a);
  std::vector<PeriodicArcs> result;
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) {
    if (!graph.arcs[a].is_boundary) continue;
    const int second = seconds[graph.arcs[a].pieces.back().curve];
    if (second < 0) continue;
    for (const int b : starting[second])
      if (is_image(graph.face, seconds, graph.arcs[a], graph.arcs[b])) result.push_back({HalfEdge{a}, HalfEdge{b}});
  }
  return result;
}

/// Both sides of slits, as pairs whose motion moves nothing.
inline std::vector<PeriodicPair> crack_pairs(const CadFace& face) {
  std::vector<PeriodicPair> pairs;
  if (face.partners.empty()) return pairs;
  const std::vector<int> regions = curve_regions(face);
  for (int c = 0; c < face.num_curves(); ++c)
    if (const int partner = face.partners[c]; partner > c && regions[c] == regions[partner])
      pairs.push_back({{c, partner}, 0, {}});
  return pairs;
}

/// Those of the face's periodic curves.
inline std::vector<PeriodicArcs> periodic_arcs(const ArcGraph& graph) {
  return periodic_arcs(graph, graph.face.periodic_pairs);
}

/// All arcs with equal nodes: those, and the ones on both sides of cracks where the blocks beside them match.
inline std::vector<PeriodicArcs> matched_arcs(const ArcGraph& graph) {
  std::vector<PeriodicPair> pairs = crack_pairs(graph.face);
  pairs.insert(pairs.begin(), graph.face.periodic_pairs.begin(), graph.face.periodic_pairs.end());
  return periodic_arcs(graph, pairs);
}

/// By arc: itself, or, for the second arc of a periodic pair, the first one backwards: a solver sees the two as one.
inline std::vector<HalfEdge> first_arcs(const ArcGraph& graph) {
  std::vector<HalfEdge> same;
  for (int a = 0; a < static_cast<int>(graph.arcs.size()); ++a) same.push_back({a});
  for (const auto& [first, second] : periodic_arcs(graph)) same[second.arc] = first.reversed();
  return same;
}

/// Throws ComputeError, with the place and `remedy`, if an arc on a periodic curve has no counterpart.
inline void require_periodic_arcs(const ArcGraph& graph, const std::string& remedy) {
  const std::vector<int> partners = periodic_partners(graph.face);
  std::vector<bool> is_paired(graph.arcs.size(), false);
  for (const auto& [first, second] : periodic_arcs(graph)) is_paired[first.arc] = is_paired[second.arc] = true;
  const auto place = [&](int node) { return position_text(graph.nodes[node].position + graph.face.origin); };
  for (std::size_t a = 0; a < graph.arcs.size(); ++a) {
    const GraphArc& arc = graph.arcs[a];
    if (!arc.is_boundary || is_paired[a]) continue;
    for (const ArcPiece& piece : arc.pieces)
      if (const int partner = partners[piece.curve]; partner >= 0)
        throw ComputeError("the blocks along the periodic curves '" + graph.face.curve_names[piece.curve] + "' and '" +
                           graph.face.curve_names[partner] + "' do not match: the side from " + place(arc.from) +
                           " to " + place(arc.to) + " has no counterpart; " + remedy);
  }
}

}  // namespace quadrille
