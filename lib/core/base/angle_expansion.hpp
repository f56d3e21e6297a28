#pragma once
// The angles from many distant points, summed at a cost that does not depend on their number: each is the imaginary
// part of a complex logarithm, so that their sum has one power series in a disc that contains none of the points.

#include <vector>

#include "base/vec2.hpp"

namespace quadrille {

/// sum_j weight_j (arg(x - a_j) - arg(centre - a_j)) in the disc round `centre`, continuous there.
class AngleExpansion {
 public:
  AngleExpansion(Vec2 centre, double radius) : centre_(centre), radius_(radius) {}

  bool contains(Vec2 x) const { return norm2(x - centre_) <= radius_ * radius_; }
  /// Whether no point of the segment from a to b is so near that it slows down the convergence.
  bool is_far(Vec2 a, Vec2 b) const;
  /// Adds the angle from `a`, which must be far; the remainder of its series is below 1e-17 |weight|.
  void add(Vec2 a, Vec2 weight);
  /// The same sum in a disc that lies inside this one, less its value at the new centre.
  AngleExpansion inside(Vec2 centre, double radius) const;
  /// The sum at x, which must be in the disc.
  Vec2 at(Vec2 x) const;

 private:
  Vec2 centre_;
  double radius_;
  // Of each component of the weights, none if it is always 0: real and imaginary parts of the coefficients of (x -
  // centre)^k / radius^k, k > 0
  struct Series {
    std::vector<double> re, im;
    /// In powers of (x - other centre) / other radius; `offset` and `scale` are relative to this disc.
    Series about(Vec2 offset, double scale) const;
  };
  Series first_, second_;
};

}  // namespace quadrille
