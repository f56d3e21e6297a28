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
  struct Box {
    Vec2 low, high;

    void extend(const Box& other);
    /// The square of the distance of x.
    double distance2(Vec2 x) const;
  };
  /// A knot span with the box around its poles, which contains it.
  struct Span {
    int curve = 0;
    double t0 = 0, t1 = 0;
    Box box;
  };
  /// A span and a parameter near the nearest point.
  struct Guess {
    std::size_t span = 0;
    double t = 0;
  };

  void add_spans(int curve);
  /// Improves the guess within its curve by Newton's method until its distance is not larger than `known`; returns it.
  double improve(Vec2 x, double known, Guess& guess) const;
  /// The distance of x, or any value up to `known` if it is not larger than that.
  double distance_above(Vec2 x, double known, Guess& guess) const;

  std::vector<Nurbs> curves_;
  std::vector<Span> spans_;
  std::vector<Box> groups_;  ///< around every so many successive spans
};

}  // namespace quadrille::curve
