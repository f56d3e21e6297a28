#include "cad/periodic_sides.hpp"

#include <fmt/format.h>

#include "base/angle.hpp"
#include "base/message_text.hpp"
#include "cad/periodic_in_space.hpp"
#include "cad/periodic_pairing.hpp"
#include "curve/face_boundary.hpp"
#include "curve/nurbs.hpp"
#include "model/periodic.hpp"
#include "surface/periodic_motion.hpp"

namespace quadrille::cad {
namespace {

constexpr int samples_per_span = 8;

/// Sides of a face in the plane (PeriodicPairing).
class PlanarSides {
 public:
  using Point = Vec2;
  struct Motion {
    GivenMotion given;  ///< in file coordinates
    PeriodicMotion relative{0, {}, {}};

    Vec2 image(Vec2 x) const { return relative.image(x); }
    Vec2 original(Vec2 x) const { return relative.original(x); }
  };

  PlanarSides(CadFace& face, const PeriodicRequest& request) : face_(face), request_(request) {}

  double diameter() const { return face_.diameter; }
  Vec2 start(int curve) const { return face_.curves[curve].poles.front(); }
  Vec2 end(int curve) const { return face_.curves[curve].poles.back(); }
  std::string place(Vec2 x) const { return position_text(x + face_.origin); }

  Motion motion_of(const GivenMotion& given) const { return {given, {given.angle, given.shift, face_.origin}}; }
  Motion given() const { return motion_of(*request_.motion); }

  // The motion that maps the line between the ends of the first part onto that of the second one.
  Motion motion_between(const SidePart& a, const SidePart& b) const {
    const Vec2 a0 = start(a.curves.front()), a1 = end(a.curves.back()), b0 = start(b.curves.front()),
               b1 = end(b.curves.back());
    const Vec2 from = (a0 + a1) / 2 + face_.origin, to = (b0 + b1) / 2 + face_.origin;
    const double angle = surface::snapped_to_fraction(wrap_pi(angle_of(b0 - b1) - angle_of(a1 - a0)));
    if (angle == 0) return motion_of({0, to - from});
    const Vec2 turn = unit(angle);
    return motion_of({angle, to - Vec2{turn.x * from.x - turn.y * from.y, turn.y * from.x + turn.x * from.y}});
  }

  std::string text(const Motion& motion) const {
    const auto& [angle, shift] = motion.given;
    return angle == 0 ? fmt::format("translate={:.9g},{:.9g}", shift.x, shift.y)
                      : fmt::format("rotate={:.9g}, about the point that maps their ends", degrees(angle));
  }

  curve::CurveTree feet_on(const std::vector<int>& curves) const {
    return curve::CurveTree(curves, [this](int c) -> const Nurbs& { return face_.curves[c]; });
  }

  std::vector<Vec2> samples(const std::vector<int>& curves) const {
    std::vector<Vec2> points;
    for (const int c : curves) {
      const Nurbs& curve = face_.curves[c];
      curve::for_each_span(curve, [&](double a, double b) {
        for (int i = 0; i < samples_per_span; ++i)
          points.push_back(curve::point(curve, a + (b - a) * i / samples_per_span));
      });
      points.push_back(curve.poles.back());
    }
    return points;
  }

  void split(int curve, double t) { split_curve(face_, curve, t); }

  PeriodicPair pair_of(int from, int to, const Motion& motion) const {
    return {{from, to}, motion.given.angle, motion.given.shift};
  }

  void replace_by_image(int from, int to, const Motion& motion) {
    Nurbs image = curve::reversed(face_.curves[from]);
    for (Vec2& pole : image.poles) pole = motion.image(pole);
    const Vec2 old_start = start(to), old_end = end(to);
    const int next = face_.next_in_loop(to);
    const double old_out = face_.joints[to].tangent_out, old_in = face_.joints[next].tangent_in;
    face_.curves[to] = image;
    move_joint(old_start, image.poles.front());
    move_joint(old_end, image.poles.back());
    const auto angle_at = [&](double t, bool from_left) { return angle_of(curve::tangent(image, t, from_left)); };
    turn_tangents(to, 0, wrap_pi(angle_at(image.begin(), false) - old_out));
    turn_tangents(next, wrap_pi(angle_at(image.end(), true) - old_in), 0);
  }

 private:
  bool are_same(Vec2 a, Vec2 b) const { return distance(a, b) <= relative_same * face_.diameter; }

  // Whatever meets a joint meets it in its new place.
  void move_joint(Vec2 from, Vec2 to) {
    for (Nurbs& curve : face_.curves) {
      if (are_same(curve.poles.front(), from)) curve.poles.front() = to;
      if (are_same(curve.poles.back(), from)) curve.poles.back() = to;
    }
    for (Joint& joint : face_.joints)
      if (are_same(joint.position, from)) joint.position = to;
  }

  void turn_tangents(int joint, double change_in, double change_out) {
    Joint& j = face_.joints[joint];
    j.tangent_in = wrap_pi(j.tangent_in + change_in);
    j.tangent_out = wrap_pi(j.tangent_out + change_out);
    j.interior_angle += change_in - change_out;
  }

  CadFace& face_;
  const PeriodicRequest& request_;
};

}  // namespace

void pair_periodic_sides(CadFace& face, const std::vector<PeriodicRequest>& requests) {
  for (const PeriodicRequest& request : requests) {
    if (face.chart) {
      pair_sides_in_space(face, request);
    } else {
      PlanarSides sides(face, request);
      PeriodicPairing(face, request, sides).pair();
    }
  }
}

}  // namespace quadrille::cad
