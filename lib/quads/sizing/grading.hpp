#pragma once
// A spacing across a chord: the monotone map between the chord's parameter u in [0, 1] and the cumulative fraction v of
// its elements before u.
//
// It is made from the prescribed length eta of an element, measured in u, at ascending u; eta is linear between. Then
// v = n(u) / n(1) with n(u) the integral of 1 / eta: elements that are equal in v have the prescribed lengths, times
// one factor for all.

#include <vector>

namespace quadrille::sizing {

/// No element between `low` and `high` may be longer than `max_length`, all in u, nor than its former length /
/// reduction.
struct MaxLengthConstraint {
  double low = 0, high = 0, max_length = 0, reduction = 1;
};

class Grading {
 public:
  /// The identity: equal elements. `count`: the number of elements, a real number > 0.
  explicit Grading(double count = 1) : count_(count) {}
  /// `u` rises from 0 to 1, `eta` > 0. Lengths that differ by less than 1e-9 of themselves make the identity.
  Grading(std::vector<double> u, std::vector<double> eta);

  bool operator==(const Grading&) const = default;
  double parameter(double v) const;   ///< u; 0 and 1 exactly at the ends
  double cumulative(double u) const;  ///< v
  double count() const { return count_; }
  bool is_identity() const { return u_.empty(); }

  /// Length of an element at u, in u.
  double element_length(double u) const;
  const std::vector<double>& samples() const { return u_; }  ///< ascending u; empty: the identity

 private:
  double count_ = 1;
  std::vector<double> u_, eta_, n_;
};

/// `count` elements by this grading, shortened to meet the constraints, and near them as required by |d eta / du| <=
/// slope. The count of the result is the number of elements that this needs.
Grading refine_grading(const Grading& grading, double count, const std::vector<MaxLengthConstraint>& constraints,
                       double slope);

/// The greatest eta' <= eta with |d eta' / du| <= slope, at the same u: neighbouring elements differ by at most the
/// factor exp(slope).
std::vector<double> limited(const std::vector<double>& u, std::vector<double> eta, double slope);

}  // namespace quadrille::sizing
