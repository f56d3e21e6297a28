#pragma once
// Graphs of several regions made by hand, with known blocks: what follows the layout must keep regions and interfaces.

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "../hand_made.hpp"

namespace quadrille::region_graphs {

using curve::reversed;

/// A face of regions, each a list of loops of curves. Curves with the same poles in opposite order are partners. Region
/// r is called "region_r".
inline CadFace face(const std::vector<std::vector<std::vector<Nurbs>>>& regions, double diameter) {
  std::vector<std::vector<Nurbs>> loops;
  std::vector<int> region_loops{0};
  for (const auto& region : regions) {
    loops.insert(loops.end(), region.begin(), region.end());
    region_loops.push_back(static_cast<int>(loops.size()));
  }
  CadFace f = hand_made::face(loops, diameter);
  if (regions.size() > 1) f.region_loops = region_loops;
  for (std::size_t r = 0; regions.size() > 1 && r < regions.size(); ++r)
    f.region_names.push_back("region_" + std::to_string(r));
  f.partners.assign(f.curves.size(), -1);
  for (int c = 0; c < f.num_curves(); ++c)
    for (int d = 0; d < f.num_curves(); ++d)
      if (c != d && f.curves[d].poles == reversed(f.curves[c]).poles) f.partners[c] = d;
  for (int c = 0; c < f.num_curves(); ++c)
    if (f.partners[c] >= 0 && f.partners[c] < c) f.curve_names[c] = f.curve_names[f.partners[c]];
  for (int c = 0; c < f.num_curves(); ++c)
    if (f.partners[c] >= 0 && f.previous_in_loop(c) == f.partners[c]) f.joints[c].interior_angle = 2 * pi;  // a tip
  return f;
}

/// A node of an interface where lines of both regions end.
inline int add_interface_node(SeparatrixGraph& g, int curve, double t) {
  return hand_made::add_node(g, curve::point(g.face.curves[curve], t), NodeKind::interface, 4, curve, t);
}

/// Unit squares side by side from the origin on; curve 1 of the left one is curve 7 of the right one.
inline SeparatrixGraph two_squares() {
  using curve::segment;
  const Nurbs middle = segment({1, 0}, {1, 1});
  SeparatrixGraph g;
  g.face = face({{{segment({0, 0}, {1, 0}), middle, segment({1, 1}, {0, 1}), segment({0, 1}, {0, 0})}},
                 {{segment({1, 0}, {2, 0}), segment({2, 0}, {2, 1}), segment({2, 1}, {1, 1}), reversed(middle)}}},
                std::sqrt(5.0));
  const int p00 = hand_made::add_joint_node(g, 0), p10 = hand_made::add_joint_node(g, 4, 2);
  const int p11 = hand_made::add_joint_node(g, 2, 2), p01 = hand_made::add_joint_node(g, 3);
  const int p20 = hand_made::add_joint_node(g, 5), p21 = hand_made::add_joint_node(g, 6);
  const auto add = [&](int from, int to, int curve, bool is_boundary = true) {
    hand_made::add_arc(g, from, to, is_boundary, {hand_made::whole(g, curve)});
  };
  add(p00, p10, 0), add(p10, p11, 1, false), add(p11, p01, 2), add(p01, p00, 3);
  add(p10, p20, 4), add(p20, p21, 5), add(p21, p11, 6);
  return g;
}

/// A disc of radius 1 in the square [-2, 2]^2: four blocks around the disc, four inside along the circle and one in its
/// middle. The circle is curve 4 of the square, clockwise, and curve 5 of the disc.
inline SeparatrixGraph disc_in_square() {
  using curve::segment;
  const Nurbs circle = curve::circular_arc({0, 0}, 1, 0, 2 * pi);
  const std::array<Vec2, 4> corner{{{-2, -2}, {2, -2}, {2, 2}, {-2, 2}}};
  std::vector<Nurbs> outline;
  for (int k = 0; k < 4; ++k) outline.push_back(segment(corner[k], corner[(k + 1) % 4]));
  SeparatrixGraph g;
  g.face = face({{outline, {reversed(circle)}}, {{circle}}}, std::sqrt(32.0));
  const Nurbs& hole = g.face.curves[4];
  // From the lower left corner on, counter-clockwise; the hole's parameter falls in this direction.
  const auto parameter = [&](double turns) { return hole.begin() + (hole.end() - hole.begin()) * (1 - turns); };
  std::array<double, 4> t{};
  for (int k = 0; k < 4; ++k) t[k] = parameter(std::fmod(0.625 + 0.25 * k, 1));
  for (int k = 0; k < 4; ++k) hand_made::add_joint_node(g, k, 2);
  for (int k = 0; k < 4; ++k) add_interface_node(g, 4, t[k]);
  for (int k = 0; k < 4; ++k) hand_made::add_node(g, 0.25 * corner[k], NodeKind::irregular, 3);
  for (int k = 0; k < 4; ++k) {
    const int next = (k + 1) % 4;
    hand_made::add_arc(g, k, next, true, {hand_made::whole(g, k)});
    std::vector<ArcPiece> pieces{{4, t[k], t[next]}};
    if (t[next] > t[k]) pieces = {{4, t[k], hole.begin()}, {4, hole.end(), t[next]}};
    hand_made::add_arc(g, 4 + k, 4 + next, false, pieces);
    hand_made::add_cut(g, 8 + k, 8 + next);
    hand_made::add_cut(g, k, 4 + k);
    hand_made::add_cut(g, 4 + k, 8 + k);
  }
  return g;
}

/// [0, 4] x [0, 2] in unit squares with a slit from (1, 1) to (3, 1), curves 4 and 5. `is_open`: a crack, whose nodes
/// are doubled but for its tips.
inline SeparatrixGraph slit_plate(bool is_open) {
  using curve::segment;
  const Nurbs slit = segment({1, 1}, {3, 1});
  SeparatrixGraph g;
  g.face = face({{{segment({0, 0}, {4, 0}), segment({4, 0}, {4, 2}), segment({4, 2}, {0, 2}), segment({0, 2}, {0, 0})},
                  {slit, reversed(slit)}}},
                std::sqrt(20.0));
  const auto number = [](int i, int j) { return 5 * j + i; };
  for (int j = 0; j <= 2; ++j)
    for (int i = 0; i <= 4; ++i) {
      const Vec2 x{1.0 * i, 1.0 * j};
      const int curve = j == 0 && i < 4 ? 0 : i == 4 && j < 2 ? 1 : j == 2 && i > 0 ? 2 : i == 0 ? 3 : -1;
      const double t = curve == 0 ? i : curve == 1 ? j : curve == 2 ? 4 - i : 2 - j;
      const bool is_corner = (i == 0 || i == 4) && j != 1;
      if (curve >= 0)
        hand_made::add_node(g, x, is_corner ? NodeKind::corner : NodeKind::boundary, is_corner ? 1 : 2, curve, t);
      else if (i != 2)
        hand_made::add_node(g, x, is_open ? NodeKind::corner : NodeKind::junction, 4, i == 1 ? 4 : 5, 0);
      else if (is_open)
        hand_made::add_node(g, x, NodeKind::boundary, 2, 4, 1);  // of the squares above, on the left of curve 4
      else
        add_interface_node(g, 4, 1);
    }
  const int below = is_open ? hand_made::add_node(g, {2, 1}, NodeKind::boundary, 2, 5, 1) : number(2, 1);
  for (int i = 0; i < 4; ++i) {
    hand_made::add_arc(g, number(i, 0), number(i + 1, 0), true, {{0, i + 0.0, i + 1.0}});
    hand_made::add_arc(g, number(i + 1, 2), number(i, 2), true, {{2, 3.0 - i, 4.0 - i}});
  }
  for (int j = 0; j < 2; ++j) {
    hand_made::add_arc(g, number(4, j), number(4, j + 1), true, {{1, j + 0.0, j + 1.0}});
    hand_made::add_arc(g, number(0, j + 1), number(0, j), true, {{3, 1.0 - j, 2.0 - j}});
    for (int i = 1; i < 4; ++i)
      hand_made::add_cut(g, i == 2 && j == 0 ? number(2, 0) : number(i, j),
                         i == 2 && j == 0 ? below : number(i, j + 1));
  }
  hand_made::add_cut(g, number(0, 1), number(1, 1));
  hand_made::add_cut(g, number(3, 1), number(4, 1));
  hand_made::add_arc(g, number(1, 1), number(2, 1), is_open, {{4, 0, 1}});
  hand_made::add_arc(g, number(2, 1), number(3, 1), is_open, {{4, 1, 2}});
  if (!is_open) return g;
  g.open_curves = {4, 5};
  hand_made::add_arc(g, number(3, 1), below, true, {{5, 0, 1}});
  hand_made::add_arc(g, below, number(1, 1), true, {{5, 1, 2}});
  return g;
}

}  // namespace quadrille::region_graphs
