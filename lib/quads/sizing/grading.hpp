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

/// The parts of [0, 1] between the positions at which elements must end (joints inside a side), and their intervals:
/// each has a least number; the others are added, one by one, to the segment whose intervals are longest. Within a
/// segment they are equal. All choices are symmetric: a chord and its mirror image are cut at mirrored positions.
struct Segments {
  std::vector<double> ends{0.0, 1.0};  ///< ascending, 0 and 1 included
  std::vector<int> least_counts{1};    ///< least number of intervals of each segment

  int least_count() const;
};

/// Counts of the segments that sum to `count` >= segments.least_count(). Empty if equal segments compete for the
/// remaining intervals, so that no choice would be symmetric, unless `break_ties`: then earlier segments are preferred.
std::vector<int> segment_counts(const Segments& segments, int count, bool break_ties);

/// The count + 1 ends of the intervals, ascending from 0 to 1.
std::vector<double> interval_ends(const Segments& segments, const std::vector<int>& counts);

}  // namespace quadrille::sizing
