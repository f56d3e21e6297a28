#include "heal/yield_curve.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/carrier.hpp"
#include "curve/nurbs.hpp"
#include "heal/heal_rules.hpp"

namespace quadrille::heal {
namespace {

// The part of the arc's circle from the point nearest to `start` to the one nearest to `end`, in the sense of the arc.
Nurbs arc_between(const curve::Carrier& circle, const Nurbs& arc, Vec2 start, Vec2 end) {
  const Vec2 from = arc.poles.front() - circle.point, to = arc.poles.back() - circle.point;
  const auto shift = [&](Vec2 radial, Vec2 x) {
    const Vec2 d = x - circle.point;
    return std::atan2(cross(radial, d), dot(radial, d));
  };
  const double sense = cross(from, curve::tangent(arc, arc.begin())) > 0 ? 1 : -1;
  const double turn = wrap_two_pi(sense * std::atan2(cross(from, to), dot(from, to)));
  const bool is_whole = std::min(turn, 2 * pi - turn) < 1e-3 &&
                        distance(curve::point(arc, (arc.begin() + arc.end()) / 2), circle.point - from) < circle.radius;
  const double sweep = !is_whole ? turn : turn < pi ? turn + 2 * pi : turn;
  const double angle0 = angle_of(from), shift0 = shift(from, start), shift1 = shift(to, end);
  return curve::circular_arc(circle.point, circle.radius, angle0 + shift0, angle0 + sense * sweep + shift1);
}

// Whether the ends of the curve are already at `start` and `end`, up to rounding.
bool ends_at(const Nurbs& curve, Vec2 start, Vec2 end) {
  const double rounding = 1e-14 * (norm(start) + norm(end) + distance(start, end));
  return distance(curve.poles.front(), start) <= rounding && distance(curve.poles.back(), end) <= rounding;
}

// The greatest distance of a point of the curve from its start.
double reach(const Nurbs& curve) {
  double greatest = 0;
  constexpr int samples = 16;
  for (int i = 1; i <= samples; ++i) {
    const double t = curve.begin() + (curve.end() - curve.begin()) * i / samples;
    greatest = std::max(greatest, distance(curve.poles.front(), curve::point(curve, t)));
  }
  return greatest;
}

// z -> start + (end - start) / (b - a) (z - a), with complex numbers.
Nurbs similar(Nurbs curve, Vec2 start, Vec2 end) {
  const Vec2 a = curve.poles.front(), chord = curve.poles.back() - a, target = end - start;
  if (norm2(chord) > 0) {
    const Vec2 ratio = Vec2{dot(chord, target), cross(chord, target)} / norm2(chord);
    for (Vec2& z : curve.poles) z = start + Vec2{dot({ratio.x, -ratio.y}, z - a), cross({ratio.x, -ratio.y}, z - a)};
  }
  return curve;
}

void add_moved(const Nurbs& curve, Vec2 start, Vec2 end, int cuts, std::vector<Nurbs>& pieces) {
  const double chord = distance(curve.poles.front(), curve.poles.back());
  const bool ends_there = ends_at(curve, start, end);
  if (ends_there || cuts == 0 || chord >= heal_rules.least_chord * reach(curve) * (1 - 1e-6)) {
    pieces.push_back(ends_there ? curve : similar(curve, start, end));
    pieces.back().poles.front() = start, pieces.back().poles.back() = end;
    return;
  }
  const double middle = (curve.begin() + curve.end()) / 2;
  const Vec2 point = curve::point(curve, middle);
  add_moved(curve::trimmed(curve, curve.begin(), middle), start, point, cuts - 1, pieces);
  add_moved(curve::trimmed(curve, middle, curve.end()), point, end, cuts - 1, pieces);
}

}  // namespace

std::vector<Nurbs> moved_curve(const Nurbs& curve, Vec2 start, Vec2 end) {
  const curve::Carrier carrier = curve::carrier_of(curve);
  if (carrier.kind == curve::CurveKind::line) return {curve::segment(start, end)};
  std::vector<Nurbs> pieces;
  const bool is_arc = carrier.kind == curve::CurveKind::arc;
  add_moved(is_arc ? arc_between(carrier, curve, start, end) : curve, start, end, heal_rules.most_cuts, pieces);
  return pieces;
}

}  // namespace quadrille::heal
