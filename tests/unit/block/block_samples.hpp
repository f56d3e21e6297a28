#pragma once
// Layouts of one block with known trouble, and the rules that a layout breaks, for the tests of lib/layout/block.

#include "../hand_made.hpp"
#include "block/extract_blocks.hpp"
#include "check/check.hpp"

namespace quadrille::block_samples {

/// Between the unit circle and a smaller one that nearly touches it at 18 degrees: narrow at one end, wide at the
/// other. Points of one fraction of both sides do not face each other, and the exact map folds.
/// `gap`: its least width; from 0.002 on the map is valid but poor. `is_mirrored`: in the x axis.
inline SeparatrixGraph near_tangent_strip(bool is_mirrored = false, double gap = 0.001) {
  const double sign = is_mirrored ? -1 : 1, radius = 0.554, high = 1.3;
  const Vec2 centre = (1 - radius - gap) * unit(sign * 0.31);
  const Vec2 near_in = centre + Vec2{radius, 0}, far_in = centre + Vec2{0, sign * radius};
  const double low = std::asin(sign * near_in.y);
  const Vec2 near_out = unit(sign * low), far_out = unit(sign * high);
  const std::vector<Nurbs> upper{curve::segment(near_in, near_out), curve::circular_arc({0, 0}, 1, low, high),
                                 curve::segment(far_out, far_in), curve::circular_arc(centre, radius, half_pi, 0)};
  const std::vector<Nurbs> lower{curve::segment(near_out, near_in), curve::circular_arc(centre, radius, 0, -half_pi),
                                 curve::segment(far_in, far_out), curve::circular_arc({0, 0}, 1, -high, -low)};
  return hand_made::one_block(hand_made::face({is_mirrored ? lower : upper}, 1.1), {{0}, {1}, {2}, {3}});
}

/// Between a thin round nose and a straight side before it, the other sides leaving the flanks of the nose at right
/// angles and longer: the exact map points into the nose.
inline SeparatrixGraph nose() {
  const Vec2 flank{0.3, 0.06}, far{-4, 4};
  Nurbs ellipse = curve::circular_arc({0, 0}, 1, -half_pi, -3 * half_pi);
  for (Vec2& pole : ellipse.poles) pole = {flank.x * (1 + pole.x), flank.y * pole.y};
  const Nurbs upper = curve::cubic_spline({0, 6}, {flank, far}, {0, 1}, std::sqrt(0.5) * Vec2{-1, 1});
  const Nurbs lower =
      curve::cubic_spline({0, 6}, {{far.x, -far.y}, {flank.x, -flank.y}}, std::sqrt(0.5) * Vec2{1, 1}, {0, 1});
  const std::vector<Nurbs> loop{curve::segment(far, {far.x, -far.y}), lower, ellipse, upper};
  return hand_made::one_block(hand_made::face({loop}, 10), {{0}, {1}, {2}, {3}});
}

/// One side dented beyond the opposite corner: no cut makes it valid.
inline SeparatrixGraph dart() {
  const std::vector<Nurbs> loop{curve::segment({0, 0}, {1, 0}), curve::segment({1, 0}, {0.1, 0.1}),
                                curve::segment({0.1, 0.1}, {0, 1}), curve::segment({0, 1}, {0, 0})};
  return hand_made::one_block(hand_made::face({loop}, std::sqrt(2.0)), {{0}, {1}, {2}, {3}});
}

/// Two darts with a common side.
inline SeparatrixGraph two_darts() {
  const std::vector<Vec2> corners{{0, 0}, {1, 0}, {0.1, 0.1}, {0, 1}, {-0.1, 0.1}, {-1, 0}};
  std::vector<Nurbs> loop;
  for (std::size_t i = 0; i < 6; ++i) loop.push_back(curve::segment(corners[i], corners[(i + 1) % 6]));
  SeparatrixGraph g;
  g.face = hand_made::face({loop}, 2);
  for (int i = 0; i < 6; ++i) hand_made::add_joint_node(g, i, i % 3 == 0 ? 2 : 1);
  for (int i = 0; i < 6; ++i) hand_made::add_arc(g, i, (i + 1) % 6, true, {hand_made::whole(g, i)});
  hand_made::add_cut(g, 0, 3);
  return g;
}

/// The broken rules of the format, one on each line; empty for a sound layout.
inline std::string faults(const BlockLayout& layout) {
  std::string all;
  for (const check::Violation& v : check::check_stage(layout, check::CheckDepth::full))
    all += v.rule + ": " + v.text + "\n";
  return all;
}

}  // namespace quadrille::block_samples
