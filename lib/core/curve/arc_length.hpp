#pragma once
// Arc length of a NURBS curve and its inverse, to round-off, from a table computed once per curve.

#include <array>
#include <cstddef>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille::curve {

class ArcLength {
 public:
  /// Gauss-Legendre on sub-intervals that are halved until two rules agree to 1e-14 of the length. Stores a pointer to
  /// `curve`, which must outlive the object.
  explicit ArcLength(const Nurbs& curve);

  double total() const { return lengths_.back(); }
  /// Length from the beginning of the curve to t.
  double at(double t) const;
  /// Length from t0 to t1, negative if t1 < t0.
  double between(double t0, double t1) const { return at(t1) - at(t0); }
  /// The parameter at `length` from the beginning (clamped to the curve), by Newton's method from the table.
  double parameter(double length) const;

 private:
  /// The derivative on one knot span of a polynomial curve of degree 3 or less, or a rational one of degree 2, as the
  /// quotient of d[0] + d[1] u + d[2] u^2, where u = t - middle, and the square of w[0] + w[1] u + w[2] u^2: a tenth of
  /// the cost of evaluating the curve.
  struct Quadratic {
    double middle = 0;
    std::array<Vec2, 3> d;
    std::array<double, 3> w = {1, 0, 0};
  };

  /// `a`, `b`: the ends of the span.
  static Quadratic quadratic(const Nurbs& curve, bool is_polynomial, double a, double b);
  void add(double parameter, double length, std::size_t span);
  /// `t` is a parameter in span number `span`; only spans that are not empty are counted.
  double speed(std::size_t span, double t) const;
  /// The length from a to b in a span by n points.
  template <int n>
  double gauss(std::size_t span, double a, double b) const;
  /// Length from parameters_[i] to t, which lies in interval i.
  double inside(std::size_t i, double t) const;
  /// Cubic guess of the parameter at `length` in interval i, from lengths and speeds at its ends.
  double guess(std::size_t i, double length) const;

  const Nurbs* curve_;
  std::vector<Quadratic> quadratics_;  // one per span; empty for other curves
  std::vector<double> parameters_, lengths_, speeds_;
  std::vector<std::size_t> spans_;  // span of the interval that ends at each parameter
  bool is_polyline_ = false, is_rational_ = false;
};

}  // namespace quadrille::curve
