#pragma once
// The cubic spline through points in space, with two continuous derivatives, by cumulated lengths of the chords; at
// either end the third derivative is continuous at the second point too ("not a knot": C. de Boor, A Practical Guide to
// Splines, 1978, ch. IV). Two points make a line, three a parabola.

#include <vector>

#include "base/vec3.hpp"

namespace quadrille::sweep {

/// Derivatives at the knots, which ascend, of such a spline through `points`; also of fewer coordinates.
std::vector<Vec3> spline_slopes(const std::vector<Vec3>& points, const std::vector<double>& knots);

class SpaceSpline {
 public:
  /// At least two points; successive ones differ.
  explicit SpaceSpline(std::vector<Vec3> points);

  /// u in [0, 1], proportional to the cumulated chord.
  Vec3 at(double u) const;
  Vec3 derivative(double u) const;  ///< with respect to u
  int num_spans() const { return static_cast<int>(points_.size()) - 1; }
  double knot(int k) const { return knots_[k]; }  ///< u of point k

 private:
  int span_of(double u) const;

  std::vector<Vec3> points_, slopes_;
  std::vector<double> knots_;
};

}  // namespace quadrille::sweep
