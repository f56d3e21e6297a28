#pragma once
// Faces and separatrix graphs made by hand, with known blocks, for tests of what follows the tracing.

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "model/separatrix_graph.hpp"

namespace quadrille::hand_made {

/// A face from loops of curves; every tangent jump above a degree is a corner.
inline CadFace face(const std::vector<std::vector<Nurbs>>& loops, double diameter) {
  CadFace f;
  f.diameter = diameter;
  f.loop_offsets = {0};
  for (const std::vector<Nurbs>& loop : loops) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Nurbs& before = loop[(i + loop.size() - 1) % loop.size()];
      Joint joint;
      joint.position = curve::point(loop[i], loop[i].begin());
      joint.tangent_in = angle_of(curve::tangent(before, before.end(), true));
      joint.tangent_out = angle_of(curve::tangent(loop[i], loop[i].begin()));
      const double turn = wrap_pi(joint.tangent_out - joint.tangent_in);
      joint.interior_angle = pi - turn;
      joint.is_corner = std::abs(turn) > radians(1);
      f.joints.push_back(joint);
      f.curve_names.push_back("side_" + std::to_string(f.curves.size()));
      f.curve_cad_edges.push_back(f.num_curves());
      f.curves.push_back(loop[i]);
    }
    f.loop_offsets.push_back(f.num_curves());
  }
  return f;
}

/// As a user does.
inline void give_name(CadFace& f, int curve, const std::string& name) {
  f.curve_names[curve] = name;
  std::erase(f.unnamed_curves, curve);
}

inline int add_node(SeparatrixGraph& g, Vec2 position, NodeKind kind, int valence, int curve = -1, double t = 0) {
  g.nodes.push_back({position, kind, valence, curve, t});
  return static_cast<int>(g.nodes.size()) - 1;
}

/// A node at the start of a curve.
inline int add_joint_node(SeparatrixGraph& g, int curve, int valence = 1) {
  return add_node(g, g.face.joints[curve].position, NodeKind::corner, valence, curve, g.face.curves[curve].begin());
}

/// A node on the boundary inside a curve.
inline int add_boundary_node(SeparatrixGraph& g, int curve, double t) {
  return add_node(g, curve::point(g.face.curves[curve], t), NodeKind::boundary, 2, curve, t);
}

inline int add_arc(SeparatrixGraph& g, int from, int to, bool is_boundary, std::vector<ArcPiece> pieces) {
  g.arcs.push_back({from, to, is_boundary, 0, std::move(pieces)});
  return static_cast<int>(g.arcs.size()) - 1;
}

/// A straight separatrix.
inline int add_cut(SeparatrixGraph& g, int from, int to) {
  g.splines.push_back(curve::segment(g.nodes[from].position, g.nodes[to].position));
  const int curve = g.face.num_curves() + static_cast<int>(g.splines.size()) - 1;
  return add_arc(g, from, to, false, {{curve, g.splines.back().begin(), g.splines.back().end()}});
}

inline ArcPiece whole(const SeparatrixGraph& g, int curve) {
  return {curve, g.face.curves[curve].begin(), g.face.curves[curve].end()};
}

/// Four corners, one boundary arc between each two; sides[k] lists the curves of side k.
inline SeparatrixGraph one_block(CadFace f, const std::vector<std::vector<int>>& sides) {
  SeparatrixGraph g;
  g.face = std::move(f);
  for (const std::vector<int>& side : sides) add_joint_node(g, side.front());
  for (int k = 0; k < 4; ++k) {
    std::vector<ArcPiece> pieces;
    for (const int curve : sides[k]) pieces.push_back(whole(g, curve));
    add_arc(g, k, (k + 1) % 4, true, pieces);
  }
  return g;
}

inline SeparatrixGraph unit_square() {
  return one_block(face({{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {1, 1}),
                          curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})}},
                        std::sqrt(2.0)),
                   {{0}, {1}, {2}, {3}});
}

inline SeparatrixGraph quarter_annulus(double inner = 1, double outer = 2) {
  return one_block(face({{curve::segment({inner, 0}, {outer, 0}), curve::circular_arc({0, 0}, outer, 0, half_pi),
                          curve::segment({0, outer}, {0, inner}), curve::circular_arc({0, 0}, inner, half_pi, 0)}},
                        std::sqrt(2.0) * outer),
                   {{0}, {1}, {2}, {3}});
}

/// Blocks of these widths side by side, 1 high from the origin on. Block i stands on curve i; then follow the right
/// side, the whole top and the left side.
inline SeparatrixGraph row(const std::vector<double>& widths) {
  const int n = static_cast<int>(widths.size());
  std::vector<double> x{0};
  for (const double width : widths) x.push_back(x.back() + width);
  std::vector<Nurbs> loop;
  for (int i = 0; i < n; ++i) loop.push_back(curve::segment({x[i], 0}, {x[i + 1], 0}));
  loop.push_back(curve::segment({x[n], 0}, {x[n], 1}));
  loop.push_back(curve::segment({x[n], 1}, {0, 1}));
  loop.push_back(curve::segment({0, 1}, {0, 0}));
  SeparatrixGraph g;
  g.face = face({loop}, norm(Vec2{x[n], 1}));
  for (int i = 0; i <= n + 2; ++i) add_joint_node(g, i, i > 0 && i < n ? 2 : 1);
  std::vector<int> top{n + 2};  // by block, from the left
  for (int i = 1; i < n; ++i) top.push_back(add_boundary_node(g, n + 1, x[n] - x[i]));
  top.push_back(n + 1);
  for (int i = 0; i < n; ++i) add_arc(g, i, i + 1, true, {whole(g, i)});
  add_arc(g, n, n + 1, true, {whole(g, n)});
  for (int i = n; i-- > 0;) add_arc(g, top[i + 1], top[i], true, {{n + 1, x[n] - x[i + 1], x[n] - x[i]}});
  add_arc(g, n + 2, 0, true, {whole(g, n + 2)});
  for (int i = 1; i < n; ++i) add_cut(g, i, top[i]);
  return g;
}

/// Three unit squares around the reflex corner (1, 1).
inline SeparatrixGraph l_shape() {
  SeparatrixGraph g;
  const std::vector<Vec2> corners{{0, 0}, {2, 0}, {2, 1}, {1, 1}, {1, 2}, {0, 2}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) loop.push_back(curve::segment(corners[i], corners[(i + 1) % 6]));
  g.face = face({loop}, std::sqrt(8.0));
  for (int i = 0; i < 6; ++i) add_joint_node(g, i, i == 3 ? 3 : 1);
  const int bottom = add_boundary_node(g, 0, 1), left = add_boundary_node(g, 5, 1);
  add_arc(g, 0, bottom, true, {{0, 0, 1}});
  add_arc(g, bottom, 1, true, {{0, 1, 2}});
  for (int i = 1; i < 5; ++i) add_arc(g, i, i + 1, true, {whole(g, i)});
  add_arc(g, 5, left, true, {{5, 0, 1}});
  add_arc(g, left, 0, true, {{5, 1, 2}});
  add_cut(g, 3, bottom);
  add_cut(g, 3, left);
  return g;
}

/// The unit disc with a hole, cut `num_cuts` times between equal angles, from 0 on.
inline SeparatrixGraph cut_annulus(int num_cuts, double hole_radius = 0.5, Vec2 hole_centre = {}) {
  SeparatrixGraph g;
  g.face = face(
      {{curve::circular_arc({0, 0}, 1, 0, 2 * pi)}, {curve::circular_arc(hole_centre, hole_radius, 2 * pi, 0)}}, 2);
  const Nurbs &out = g.face.curves[0], &in = g.face.curves[1];
  const auto share = [](const Nurbs& c, double f) { return c.begin() * (1 - f) + c.end() * f; };
  std::vector<int> outer, inner;
  for (int k = 0; k < num_cuts; ++k) {
    const double f = static_cast<double>(k) / num_cuts;
    outer.push_back(add_boundary_node(g, 0, share(out, f)));
    inner.push_back(add_boundary_node(g, 1, share(in, 1 - f)));
    g.nodes[outer.back()].kind = g.nodes[inner.back()].kind = NodeKind::cut;
  }
  for (int k = 0; k < num_cuts; ++k) {
    const int next = (k + 1) % num_cuts;
    const double f = static_cast<double>(k) / num_cuts, h = static_cast<double>(k + 1) / num_cuts;
    add_arc(g, outer[k], outer[next], true, {{0, share(out, f), share(out, h)}});
    add_arc(g, inner[next], inner[k], true, {{1, share(in, 1 - h), share(in, 1 - f)}});
    add_cut(g, outer[k], inner[k]);
  }
  return g;
}

/// A duct of width 1: straight, a 60 degree bend to the left, straight, one to the right, straight. One block whose
/// long sides pass four joints each.
inline SeparatrixGraph s_bend() {
  const double a = pi / 3, w = 0.5, radius = 2;
  const Vec2 d = unit(a), c1{2, radius}, p1 = c1 + radius * unit(a - half_pi), p2 = p1 + d;
  const Vec2 c2 = p2 - radius * left_of(d), p3 = c2 + Vec2{0, radius}, n = w * left_of(d), up{0, w}, run{2, 0};
  const std::vector<Nurbs> loop{
      curve::segment(-up, Vec2{2, 0} - up),   curve::circular_arc(c1, radius + w, -half_pi, a - half_pi),
      curve::segment(p1 - n, p2 - n),         curve::circular_arc(c2, radius - w, a + half_pi, half_pi),
      curve::segment(p3 - up, p3 + run - up), curve::segment(p3 + run - up, p3 + run + up),
      curve::segment(p3 + run + up, p3 + up), curve::circular_arc(c2, radius + w, half_pi, a + half_pi),
      curve::segment(p2 + n, p1 + n),         curve::circular_arc(c1, radius - w, a - half_pi, -half_pi),
      curve::segment(Vec2{2, 0} + up, up),    curve::segment(up, -up)};
  return one_block(face({loop}, distance(p3 + run + up, -up)), {{0, 1, 2, 3, 4}, {5}, {6, 7, 8, 9, 10}, {11}});
}

/// A duct of width 1: straight for 1, then a quarter turn to the left (radii 1 and 2). Each long side is line and arc.
inline SeparatrixGraph elbow() {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {1, 0}), curve::circular_arc({1, 2}, 2, -half_pi, 0),
                                curve::segment({3, 2}, {2, 2}), curve::circular_arc({1, 2}, 1, 0, -half_pi),
                                curve::segment({1, 1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  CadFace bent = face({loop}, std::sqrt(13.0));
  for (int c = 0; c < bent.num_curves(); ++c) {
    bent.curve_names[c] = "curve_" + std::to_string(c);
    bent.unnamed_curves.push_back(c);
  }
  return one_block(std::move(bent), {{0, 1}, {2}, {3, 4}, {5}});
}

}  // namespace quadrille::hand_made
