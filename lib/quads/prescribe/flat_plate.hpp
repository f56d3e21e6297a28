#pragma once
// The height of a first wall layer from a prescribed y+, as on a flat plate with a turbulent boundary layer.
//
//   y = y+ nu / u_tau,  u_tau = U sqrt(c_f / 2),  c_f = (2 log10 Re_x - 0.65)^-2.3,  Re_x = U x / nu.
//
// c_f is the local skin friction of a smooth plate at the length x: H. Schlichting, Boundary-Layer Theory, 7th ed.,
// 1979, ch. XXI. It holds for Re_x between 5e5 and 1e9; where the layer is laminar, friction is less and y too small.

#include "base/report.hpp"

namespace quadrille::prescribe {

/// All in units that fit together: lengths in one unit, viscosity in length^2 / time. 0: not given.
struct PlateFlow {
  double velocity = 0;   ///< U of the free stream
  double viscosity = 0;  ///< nu, kinematic
  double length = 0;     ///< x, from the leading edge to where y+ applies

  double reynolds_number() const { return velocity * length / viscosity; }
  double skin_friction() const;
  /// In the unit of `length`.
  double height(double yplus) const;
  /// Throws UsageError, which names the missing options, unless all are given if `is_used`, and none if not; and if the
  /// Reynolds number is below 1000, for which the formula means nothing.
  void validate(bool is_used) const;
};

/// Sets flow.* and issues a warning outside the interval of the formula.
void report_flow(const PlateFlow& flow, Report& report);

}  // namespace quadrille::prescribe
