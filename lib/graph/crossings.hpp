#pragma once
// All places where spline curves cross each other or themselves.
//
// Every span is taken as a Bezier cubic; pairs that nothing separates are halved until they turn less than the angle
// between them, then Newton's method finds the one crossing that they may have. Curves are C2, so tangential contacts
// of one curve with itself do not occur.

#include <vector>

#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::graph {

/// Curve a at parameter s meets curve b at parameter t; a < b, or a == b and s < t.
struct Crossing {
  int a = 0, b = 0;
  double s = 0, t = 0;
  Vec2 position;
  double angle = 0;  ///< between the two tangents taken as undirected lines, radians in [0, pi/2]
};

/// Splines that lie beside each other again and again, as the laps of a spiral do, would cost the square of their
/// pieces.
struct CrossingBounds {
  /// Pairs of pieces whose boxes meet, halved ones included. The plates of 100 holes need half a million.
  long long max_pairs = 10'000'000;
  Vec2 origin{};             ///< added to places in messages
  std::vector<bool> sought;  ///< pairs of which neither curve is marked are left out; empty: none are
};

/// The sequence that crossings come in: by (a, s, b).
bool comes_before(const Crossing& x, const Crossing& y);

/// Crossings of non-rational cubic splines (curve/nurbs.hpp, cubic_spline), sorted by (a, s, b). Two finds of one pair
/// closer than `same` (a length) count as one. Curves that meet at an end are reported there too, where they do not
/// merely touch within round-off. Throws ComputeError with a place where a bound is met.
std::vector<Crossing> find_crossings(const std::vector<Nurbs>& splines, double same, const CrossingBounds& bounds = {});

}  // namespace quadrille::graph
