#pragma once
// Distance of points from many curves, by projection: the boundary of a face, or that of a mesh.

#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

struct FarthestPoint {
  double distance = 0;
  Vec2 position;
};

class CurveSet {
 public:
  /// The curves must have positive weights.
  explicit CurveSet(std::vector<Nurbs> curves);

  /// The point with the largest distance from the nearest curve; no curve: distance 0. Fastest if neighbours in
  /// `points` are near each other: the cost of a point is then that of a few Newton steps, otherwise it is linear in
  /// the number of knot spans.
  FarthestPoint farthest(const std::vector<Vec2>& points) const;

 private:
  /// A knot span with the box around its poles, which contains it.
  struct Span {
    int curve = 0;
    double t0 = 0, t1 = 0;
    Vec2 low, high;

    double distance_of_box(Vec2 x) const;
  };
  /// A span and a parameter near the nearest point.
  struct Guess {
    std::size_t span = 0;
    double t = 0;
  };

  void add_spans(int curve);
  /// Improves the guess within its curve by Newton's method; returns its distance.
  double improve(Vec2 x, Guess& guess) const;
  /// The distance of x, or any value up to `known` if it is not larger than that.
  double distance_above(Vec2 x, double known, Guess& guess) const;

  std::vector<Nurbs> curves_;
  std::vector<Span> spans_;
};

}  // namespace quadrille::curve
