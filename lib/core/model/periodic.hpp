#pragma once
// Periodic sides of a face: two curves of which a motion maps the first onto the second, reversed. A solver sees them
// as one, so their nodes are images of each other.

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

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

}  // namespace quadrille
