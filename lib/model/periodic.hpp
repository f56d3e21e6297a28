#pragma once
// Periodic sides of a face: two curves of which a motion maps the first onto the second, reversed. A solver sees them
// as one, so their nodes are images of each other.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec2.hpp"
#include "model/arc_graph.hpp"
#include "model/half_edge.hpp"

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

/// By arc: itself, or, for an arc on the second curve of a pair, the arc on the first one of which it is the image,
/// backwards: a solver sees the two as one. Also itself if its image is no arc, or reaches beyond the pair's curves.
inline std::vector<HalfEdge> periodic_arcs(const CadFace& face, const std::vector<GraphArc>& arcs) {
  std::vector<HalfEdge> same;
  for (int a = 0; a < static_cast<int>(arcs.size()); ++a) same.push_back({a});
  std::vector<int> originals(face.curves.size(), -1);  // of second curves: the first
  for (const PeriodicPair& pair : face.periodic_pairs) originals[pair.curves[1]] = pair.curves[0];
  std::vector<std::vector<int>> ending(face.curves.size());  // boundary arcs whose last piece is on the curve
  if (!face.periodic_pairs.empty())
    for (int a = 0; a < static_cast<int>(arcs.size()); ++a)
      if (arcs[a].is_boundary) ending[arcs[a].pieces.back().curve].push_back(a);
  const auto is_image = [&](const ArcPiece& of, double t_of, const ArcPiece& on, double t_on) {
    return originals[on.curve] == of.curve &&
           is_same_parameter(face.curves[on.curve], periodic_parameter(face, of.curve, t_of, on.curve), t_on);
  };
  for (int b = 0; b < static_cast<int>(arcs.size()) && !face.periodic_pairs.empty(); ++b) {
    if (!arcs[b].is_boundary) continue;
    const ArcPiece first = arcs[b].pieces.front(), last = arcs[b].pieces.back();
    if (originals[first.curve] < 0) continue;
    for (const int a : ending[originals[first.curve]])
      if (is_image(arcs[a].pieces.back(), arcs[a].pieces.back().t1, first, first.t0) &&
          is_image(arcs[a].pieces.front(), arcs[a].pieces.front().t0, last, last.t1))
        same[b] = {a, true};
  }
  return same;
}

}  // namespace quadrille
