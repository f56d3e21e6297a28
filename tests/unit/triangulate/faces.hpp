#pragma once
// Faces made by hand, for the tests of this folder.

#include <algorithm>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "model/cad_face.hpp"

namespace quadrille::testing_faces {

using Loop = std::vector<Nurbs>;

inline Joint make_joint(const CadFace& face, int curve) {
  const Nurbs& in = face.curves[face.previous_in_loop(curve)];
  const Nurbs& out = face.curves[curve];
  Joint joint;
  joint.position = out.poles.front();
  joint.tangent_in = angle_of(curve::tangent(in, in.end(), true));
  joint.tangent_out = angle_of(curve::tangent(out, out.begin()));
  const double turn = wrap_pi(joint.tangent_out - joint.tangent_in);
  joint.interior_angle = std::abs(turn) < 1e-9 ? pi : pi - turn;
  joint.is_corner = std::abs(turn) > radians(1.0);
  return joint;
}

inline double diameter_of(const CadFace& face) {
  std::vector<Vec2> points;
  for (int c = 0; c < face.loop_offsets[1]; ++c) {
    const Nurbs& curve = face.curves[c];
    for (int i = 0; i <= 64; ++i)
      points.push_back(curve::point(curve, curve.begin() + (curve.end() - curve.begin()) * i / 64));
  }
  double diameter = 0;
  for (const Vec2 a : points)
    for (const Vec2 b : points) diameter = std::max(diameter, distance(a, b));
  return diameter;
}

/// The outline first, counter-clockwise; holes clockwise.
inline CadFace make_face(const std::vector<Loop>& loops) {
  CadFace face;
  face.loop_offsets = {0};
  for (const Loop& loop : loops) {
    for (const Nurbs& curve : loop) face.curves.push_back(curve);
    face.loop_offsets.push_back(face.num_curves());
  }
  face.curve_names.assign(face.num_curves(), "");
  for (int c = 0; c < face.num_curves(); ++c) {
    face.curve_cad_edges.push_back(c);
    face.curves[face.previous_in_loop(c)].poles.back() = face.curves[c].poles.front();
  }
  for (int c = 0; c < face.num_curves(); ++c) face.joints.push_back(make_joint(face, c));
  face.diameter = diameter_of(face);
  return face;
}

inline Loop polygon(const std::vector<Vec2>& points) {
  Loop loop;
  for (std::size_t i = 0; i < points.size(); ++i)
    loop.push_back(curve::segment(points[i], points[(i + 1) % points.size()]));
  return loop;
}

inline Loop circle(Vec2 centre, double radius) { return {curve::circular_arc(centre, radius, 0, 2 * pi)}; }
inline Loop hole(Vec2 centre, double radius) { return {curve::circular_arc(centre, radius, 2 * pi, 0)}; }

inline CadFace square() { return make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}})}); }
inline CadFace half_disc() {
  return make_face({{curve::segment({-1, 0}, {1, 0}), curve::circular_arc({0, 0}, 1, 0, pi)}});
}
inline CadFace annulus() { return make_face({circle({0, 0}, 1), hole({0, 0}, 0.5)}); }
inline CadFace l_shape() { return make_face({polygon({{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}})}); }
inline CadFace stadium() {
  return make_face({{curve::segment({-1, -1}, {1, -1}), curve::circular_arc({1, 0}, 1, -pi / 2, pi / 2),
                     curve::segment({1, 1}, {-1, 1}), curve::circular_arc({-1, 0}, 1, pi / 2, 1.5 * pi)}});
}

/// Declares curves `a` and `b`, which run along each other in opposite directions, the sides of a slit.
inline void pair_sides(CadFace& face, int a, int b) {
  face.partners.resize(face.num_curves(), -1);
  face.partners[a] = b;
  face.partners[b] = a;
  for (const auto& [in, out] : {std::pair(a, b), std::pair(b, a)})
    if (face.next_in_loop(in) == out) face.joints[out].interior_angle = 2 * pi;
}
inline Loop slit(const Nurbs& curve) { return {curve, curve::reversed(curve)}; }
/// A square with a straight slit.
inline CadFace slit_square() {
  CadFace face = make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), slit(curve::segment({0.3, 0.5}, {0.7, 0.5}))});
  pair_sides(face, 4, 5);
  return face;
}
/// A square with a slit along an arc.
inline CadFace arc_slit() {
  CadFace face =
      make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), slit(curve::circular_arc({0.5, 0.5}, 0.3, 0, 2.5))});
  pair_sides(face, 4, 5);
  return face;
}
/// A square with a slit from the middle of its right side.
inline CadFace open_slit() {
  CadFace face = make_face({polygon({{0, 0}, {1, 0}, {1, 0.5}, {0.5, 0.5}, {1, 0.5}, {1, 1}, {0, 1}})});
  pair_sides(face, 2, 3);
  return face;
}
/// A unit square with a slit that bends by `turn` radians in the middle of the square.
inline CadFace bent_slit(double turn) {
  const Vec2 a{0.25, 0.5}, b{0.5, 0.5}, c = b + 0.25 * unit(turn);
  CadFace face = make_face({polygon({{0, 0}, {1, 0}, {1, 1}, {0, 1}}), polygon({a, b, c, b})});
  pair_sides(face, 4, 7);
  pair_sides(face, 5, 6);
  return face;
}
/// A square with a round hole from which a slit starts at 30 degrees to the normal.
inline CadFace slanted_slit() {
  const Vec2 foot = unit(1.0), tip = foot + 1.5 * unit(1.0 + pi / 6);
  CadFace face = make_face(
      {polygon({{-4, -4}, {4, -4}, {4, 4}, {-4, 4}}),
       {curve::circular_arc({0, 0}, 1, 1.0, 1.0 - 2 * pi), curve::segment(foot, tip), curve::segment(tip, foot)}});
  pair_sides(face, 5, 6);
  return face;
}
/// The part of a square beside a triangle and a quadrangle that meet in its middle: it touches itself there, with
/// sectors of 117 and 90 degrees.
inline CadFace pinched_square() {
  return make_face({polygon({{1, -2}, {2, -2}, {2, 2}, {-2, 2}, {-2, -2}, {0, 0}, {-1, 1}, {1, 1}, {0, 0}})});
}
/// An annulus cut along a radius: one loop.
inline CadFace cut_annulus() {
  CadFace face = make_face({{curve::circular_arc({0, 0}, 1, 0, 2 * pi), curve::segment({1, 0}, {0.5, 0}),
                             curve::circular_arc({0, 0}, 0.5, 2 * pi, 0), curve::segment({0.5, 0}, {1, 0})}});
  pair_sides(face, 1, 3);
  return face;
}

/// The whole face moved by x -> scale * R(angle) x + shift; mirrored about the x axis first where asked.
inline CadFace moved(const CadFace& face, double scale, double angle, Vec2 shift, bool mirrored = false) {
  const Vec2 d = scale * unit(angle);
  std::vector<Loop> loops;
  for (int l = 0; l < face.num_loops(); ++l) {
    Loop loop(face.curves.begin() + face.loop_offsets[l], face.curves.begin() + face.loop_offsets[l + 1]);
    for (Nurbs& curve : loop) {
      for (Vec2& p : curve.poles) {
        const double y = mirrored ? -p.y : p.y;
        p = Vec2{d.x * p.x - d.y * y, d.y * p.x + d.x * y} + shift;
      }
      if (mirrored) curve = curve::reversed(curve);
    }
    if (mirrored) std::reverse(loop.begin(), loop.end());
    loops.push_back(loop);
  }
  return make_face(loops);
}

}  // namespace quadrille::testing_faces
