#pragma once
// Arc length of a NURBS curve and its inverse, to round-off, from a table made once per curve.

#include <cstddef>
#include <vector>

#include "model/cad_face.hpp"

namespace quadrille {

class ArcLength {
 public:
  /// Gauss-Legendre on sub-intervals that are halved until two rules agree to 1e-14 of the length.
  /// Keeps a pointer to `curve`, which must outlive it.
  explicit ArcLength(const Nurbs& curve);

  double total() const { return lengths_.back(); }
  /// Length from the curve's beginning to t.
  double at(double t) const;
  /// Length from t0 to t1, negative when t1 < t0.
  double between(double t0, double t1) const { return at(t1) - at(t0); }
  /// The parameter at `length` from the beginning (clamped), by Newton from the table.
  double parameter(double length) const;

 private:
  void add(double parameter, double length);
  /// Length from parameters_[i] to t, which lies in interval i.
  double inside(std::size_t i, double t) const;
  /// Cubic guess of the parameter at `length` in interval i, from lengths and speeds at its ends.
  double guess(std::size_t i, double length) const;

  const Nurbs* curve_;
  std::vector<double> parameters_, lengths_, speeds_;
  bool is_polyline_ = false;
};

}  // namespace quadrille
