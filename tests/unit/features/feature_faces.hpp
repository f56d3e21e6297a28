#pragma once
// Faces with small features, and nodes where these put them (lib/method.md §5): a convex right angle of radius r has
// its node of valence 3 at 0.312 r from the arc, a reflex one its node of valence 5 at 0.407 r.

#include <algorithm>
#include <cmath>
#include <vector>

#include "../hand_made.hpp"
#include "../support/critical_points.hpp"
#include "base/tolerance.hpp"
#include "curve/nurbs.hpp"
#include "features/feature_state.hpp"

namespace quadrille::features::testing_features {

using hand_made::corners_of;
using hand_made::expect_sound_changes;

inline constexpr double convex_depth = 0.312, reflex_depth = 0.407;

using Loop = std::vector<Nurbs>;

/// A polygon in the given order (holes clockwise) with fillets of these radii; 0: a sharp corner.
inline Loop filleted(const std::vector<Vec2>& corners, const std::vector<double>& radii) {
  const size_t n = corners.size();
  std::vector<Vec2> before(n), after(n);
  std::vector<Nurbs> arcs(n);
  for (size_t i = 0; i < n; ++i) {
    const Vec2 in = normalized(corners[i] - corners[(i + n - 1) % n]),
               out = normalized(corners[(i + 1) % n] - corners[i]);
    const double turn = std::atan2(cross(in, out), dot(in, out)), cut = radii[i] * std::tan(std::abs(turn) / 2);
    before[i] = corners[i] - cut * in;
    after[i] = corners[i] + cut * out;
    if (radii[i] == 0) continue;
    const double side = turn > 0 ? 1 : -1, start = angle_of(in) - side * half_pi;
    arcs[i] = curve::circular_arc(before[i] + side * radii[i] * left_of(in), radii[i], start, start + turn);
  }
  Loop loop;
  for (size_t i = 0; i < n; ++i) {
    if (radii[i] > 0) loop.push_back(arcs[i]);
    loop.push_back(curve::segment(after[i], before[(i + 1) % n]));
  }
  return loop;
}

inline Loop rectangle(Vec2 low, Vec2 high, double radius) {
  return filleted({low, {high.x, low.y}, high, {low.x, high.y}}, {radius, radius, radius, radius});
}

/// A rectangular hole.
inline Loop window(Vec2 low, Vec2 high, double radius) {
  return filleted({low, {low.x, high.y}, high, {high.x, low.y}}, {radius, radius, radius, radius});
}

inline Loop round_hole(Vec2 centre, double radius) { return {curve::circular_arc(centre, radius, 0, -2 * pi)}; }

/// [-half, half]^2 with sharp corners and these holes.
inline CadFace plate(double half, const std::vector<Loop>& holes = {}) {
  std::vector<Loop> loops{rectangle({-half, -half}, {half, half}, 0)};
  loops.insert(loops.end(), holes.begin(), holes.end());
  return hand_made::face(loops, half * std::sqrt(8.0));
}

inline FeatureNode inner_node(Vec2 at, int valence) {
  FeatureNode node;
  node.position = at;
  node.valence = valence;
  return node;
}

inline FeatureNode boundary_node(const CadFace& face, int curve, double t, int valence = 3) {
  FeatureNode node = inner_node(curve::point(face.curves[curve], t), valence);
  node.location = NodeLocation::boundary;
  node.curve = curve;
  node.t = t;
  return node;
}

/// A state without corners.
inline FeatureState state_of(const CadFace& face, double size, const std::vector<FeatureNode>& nodes) {
  FeatureState state;
  state.size = size;
  state.tie = tolerance::tied * face.diameter;
  state.nodes = nodes;
  return state;
}

}  // namespace quadrille::features::testing_features
