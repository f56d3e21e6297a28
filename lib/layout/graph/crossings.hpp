#pragma once
// All crossings of spline curves with each other and with themselves.
//
// Every span is represented as a Bezier cubic; pairs that cannot be separated are halved until they turn by less than
// the angle between them, then Newton's method finds the only crossing that is possible. Curves are C2, so tangential
// contacts of one curve with itself do not occur.

#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <vector>

#include "base/error.hpp"
#include "base/vec2.hpp"
#include "model/cad_face.hpp"

namespace quadrille::graph {

/// Radians in [0, pi].
inline double angle_between(Vec2 a, Vec2 b) { return std::abs(std::atan2(cross(a, b), dot(a, b))); }

/// Curve a at parameter s meets curve b at parameter t; a < b, or a == b and s < t.
struct Crossing {
  int a = 0, b = 0;
  double s = 0, t = 0;
  Vec2 position;
  double angle = 0;  ///< between the two tangents as undirected lines, radians in [0, pi/2]
};

/// Limits of the search: splines that lie beside each other many times, as the laps of a spiral, would need a number of
/// pairs quadratic in the number of pieces.
struct CrossingBounds {
  /// Pairs of pieces whose boxes meet, halved ones included. The plates of 100 holes need half a million.
  long long max_pairs = 10'000'000;
  std::size_t max_crossings = std::numeric_limits<std::size_t>::max();  ///< of the pairs searched
  const CadFace* face = nullptr;   ///< if given, positions in messages are in the coordinates of its file
  std::vector<bool> sought;        ///< only pairs with a marked curve are searched; empty: all pairs are
  long long* num_pairs = nullptr;  ///< if given, the pairs of the search are added to it
};

/// Lines cross each other so often that a bound on the number of crossings or arcs is exceeded.
class CrowdedLinesError : public ComputeError {
 public:
  using ComputeError::ComputeError;
};

/// Crossings of non-rational cubic splines (curve/nurbs.hpp, cubic_spline), sorted by (a, s, b). Two finds of one pair
/// closer than `same` (a length) count as one. Curves that meet at an end are reported there too, where they do not
/// merely touch within round-off. Throws ComputeError (for max_crossings: CrowdedLinesError) with a position if a limit
/// is reached.
std::vector<Crossing> find_crossings(const std::vector<Nurbs>& splines, double same, const CrossingBounds& bounds = {});

/// Curves with equal keys are the same curve in all searches.
using CurveKey = std::array<double, 3>;

/// Cached crossings of curves, few of which change from one search to the next.
class CrossingCache {
 public:
  /// find_crossings(splines, same, bounds), searched only for pairs with a new curve; bounds.sought is not used. Curves
  /// that occur again must keep their order. The pairs of all searches together are at most four times max_pairs, and
  /// in proportion more of more than 500 curves; throws ComputeError beyond.
  const std::vector<Crossing>& find(const std::vector<CurveKey>& keys, const std::vector<Nurbs>& splines, double same,
                                    CrossingBounds bounds);

 private:
  std::map<CurveKey, int> numbers_;
  std::vector<Crossing> crossings_;
  long long num_pairs_ = 0;
};

}  // namespace quadrille::graph
