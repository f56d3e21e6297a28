#pragma once
// A curve that goes on straight beyond its ends, and where two of them cross.

#include <optional>

#include "model/cad_face.hpp"

namespace quadrille::offset {

class ExtendedCurve {
 public:
  /// Stores a pointer to `curve`, which must outlive the object.
  explicit ExtendedCurve(const Nurbs& curve) : curve_(&curve) {}

  const Nurbs& curve() const { return *curve_; }
  Vec2 point(double t) const;
  Vec2 derivative(double t) const;
  /// The parameter at about this length beyond the beginning or, with a negative length, before it; the same at the
  /// end.
  double beside_start(double length) const;
  double beside_end(double length) const;

 private:
  const Nurbs* curve_;
};

struct ExtendedCrossing {
  double t_a = 0, t_b = 0;  ///< parameters on both curves
  Vec2 position;
};

/// The crossing that Newton's method finds from these parameters, within `tolerance`, a length; std::nullopt if none.
std::optional<ExtendedCrossing> crossing_near(const ExtendedCurve& a, double t_a, const ExtendedCurve& b, double t_b,
                                              double tolerance);

}  // namespace quadrille::offset
