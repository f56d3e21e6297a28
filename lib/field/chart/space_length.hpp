#pragma once
// Arc lengths of curves in space.

#include <vector>

#include "model/chart.hpp"

namespace quadrille::chart {

class SpaceLength {
 public:
  /// Gauss-Legendre between knots, halved until two rules agree to round-off, that of parameters too. `curve` must
  /// outlive this.
  explicit SpaceLength(const SpaceCurve& curve);

  double total() const { return lengths_.back(); }
  /// Length from the beginning of the curve to t.
  double at(double t) const;
  /// The parameter at `length` from the beginning (clamped to the curve).
  double parameter(double length) const;
  const SpaceCurve& curve() const { return *curve_; }

 private:
  double gauss(double a, double b) const;
  void add(double a, double b, double whole, double tolerance, int depth);

  const SpaceCurve* curve_;
  std::vector<double> parameters_, lengths_;
};

}  // namespace quadrille::chart
