#pragma once
// The liftings of a field as seen from a group of neighbouring elements: those far from it are summed by one power
// series. A face of hundreds of corners has as many liftings, and each cell of the search for zeros needs the value and
// the gradient of all.
//
//   theta_c = Im (log(z - c) - log(z - p_c)),   log(z - a) = log(z_0 - a) - sum_k (q t)^k / k,
//   t = (z - z_0) / R,   q = R / (a - z_0),   |q| <= 1/3 for the far ones

#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

/// Liftings as seen from a disc.
struct LiftingGroup {
  Vec2 centre;
  double radius = 0;
  std::vector<Lifting> near_liftings;  ///< each to be evaluated; the others are far
  double bend = 0;                     ///< sum over far liftings of |jump| times a bound of |theta''| in the disc
  double jumps = 0;                    ///< sum of their |jump|
  double rounding = 0;                 ///< sum of |jump| times a bound of |theta'|
  Vec2 at_centre;                      ///< the sum of the far liftings
  std::vector<Vec2> u, v;  ///< complex coefficients of t, t^2, ... of the far sum less at_centre, of each component

  bool contains(Vec2 x, double around) const { return distance(x, centre) + around <= radius; }
  /// The far sum at x in the disc, and its gradient, which is added to `gradient` (rows u, v).
  Vec2 far_sum(Vec2 x, Mat2& gradient) const;
};

/// The groups of all elements, each made when it is first asked for, and brought up to date when
/// it is asked for again. With fewer than 64 liftings all are near.
class FarLiftings {
 public:
  /// `evaluator` must outlive it. When jumps of its field's liftings have changed, renew() must follow.
  explicit FarLiftings(const field::FieldEvaluator& evaluator);
  const LiftingGroup& of(int elem);
  /// As FieldEvaluator::sample, by the group of the element.
  field::FieldSample sample(int elem, Vec2 xi);
  void renew();

 private:
  void group_elements();
  void update(LiftingGroup& group, std::vector<Vec2>& jumps) const;

  const field::FieldEvaluator* evaluator_;
  std::vector<int> elem2group_;
  std::vector<LiftingGroup> groups_;
  std::vector<Vec2> jumps_;                     ///< of each lifting
  std::vector<std::vector<Vec2>> group2jumps_;  ///< those that the group has
  std::vector<bool> is_current_;
};

}  // namespace quadrille::zeros
