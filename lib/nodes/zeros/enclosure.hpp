#pragma once
// An enclosure of the guiding field over a cell: a polygon of values and a set of Jacobians, liftings included.
//
// Over a cell each lifting angle is theta(x0) + grad theta(x0) . (x - x0) + rest, |rest| <= r^2 sup|theta''| / 2, with
// r the cell's radius about x0. The linear part is added to the polynomial exactly; the rest widens it along the
// lifting's jump. Close to a corner, where theta'' is unbounded, theta is enclosed by the angles at which the corner
// sees the cell's Bernstein points instead.

#include <algorithm>
#include <cmath>
#include <vector>

#include "field/evaluate.hpp"
#include "zeros/cell.hpp"
#include "zeros/far_liftings.hpp"

namespace quadrille::zeros {

class Enclosure {
 public:
  /// Recomputes everything for `cell`, which must live as long as the results are used; storage is reused. `margin`:
  /// uncertainty of the field itself (zeros/zero_search); a value of at most this length may be a zero.
  void set(const Cell& cell, const std::vector<Lifting>& liftings, double margin = 0);
  /// The same with the liftings of `field` as seen from a group that contains the cell: the rests of the far ones widen
  /// it in all directions.
  void set(const Cell& cell, const Field& field, const LiftingGroup& group, double margin = 0);

  /// True if the field has no zero in the cell: a direction separates its values from 0 (Gilbert 1966).
  bool excludes_zero() const { return separation(0) > 0; }
  /// A lower bound of |v| over the cell, less its uncertainty; 0 if it may have a zero. At least half of the best that
  /// the polygon gives, mostly.
  double least_value() const { return std::max(separation(0.5), 0.0); }
  /// True if the field is injective on the cell, so that it has at most one zero there: with inverse_jacobian = J0^-1,
  /// J0 a mean of d v / d lambda, |J0^-1 dv/dlambda - I| <= contraction < 1 everywhere.
  bool isolates(Mat2& inverse_jacobian, double& contraction) const;

  /// An upper bound of |v| over the cell.
  double greatest_value() const;
  /// Bound of the change of a value of the field over the cell by rounding and the margin.
  double value_noise() const { return slack_ + margin_; }
  Vec2 centre() const { return centre_; }
  double radius() const { return radius_; }

 private:
  struct Range {
    Vec2 jump;
    double half_width;  ///< of the angle's rest
  };
  void set_polynomial(const Cell& cell, double margin);
  void add_liftings(const std::vector<Lifting>& liftings, Vec2& shift, Mat2& slope, double& size, double& rounding);
  void finish(Vec2 shift, const Mat2& slope, double size, double rounding);
  void add_linearised(const Lifting& lifting, Vec2& shift, Mat2& slope);  ///< linear parts go into shift and slope
  void add_by_angles(const Lifting& lifting);
  double support(Vec2 direction) const;
  bool surrounds_zero() const;
  double separation(double part) const;

  const Cell* cell_ = nullptr;
  Vec2 centre_;
  double radius_ = 0;
  double slack_ = 0;  ///< round-off of values: of coefficients, and of positions near corners
  double margin_ = 0;
  std::vector<Vec2> values_;  ///< Bernstein coefficients of the field with linearised liftings
  std::vector<Range> ranges_;
  double far_rest_ = 0;        ///< bound of the rests of the liftings that are far from a group of elements
  double gradient_error_ = 0;  ///< of d v / d x; infinite when a lifting could not be linearised
};

}  // namespace quadrille::zeros
