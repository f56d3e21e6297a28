#pragma once
// A spacing across a chord: the monotone map between the chord's parameter u in [0, 1] and the share v of its elements.
//
// It is made from the wanted length eta of an element, measured in u, at a rising sequence of u; eta is linear between.
// Then v = n(u) / n(1) with n(u) the integral of 1 / eta: elements that are equal in v have the wanted lengths, times
// one factor for all.

#include <vector>

namespace quadrille::sizing {

/// No element between `low` and `high` shall be longer than `eta`, all in u, nor than 1 / excess of what it was.
struct LengthDemand {
  double low = 0, high = 0, eta = 0, excess = 1;
};

class Grading {
 public:
  /// The identity: equal elements. `count`: the wanted number of elements, as a real number > 0.
  explicit Grading(double count = 1) : count_(count) {}
  /// `u` rises from 0 to 1, `eta` > 0. Lengths that differ by less than 1e-9 of themselves make the identity.
  Grading(std::vector<double> u, std::vector<double> eta);

  double parameter(double v) const;  ///< u; 0 and 1 exactly at the ends
  double share(double u) const;      ///< v
  double count() const { return count_; }
  bool is_identity() const { return u_.empty(); }

  /// What `count` elements make of this grading, shortened where they are longer than demanded, and about these places
  /// as far as |d eta / du| <= slope asks for. Its own count says how many elements that takes.
  Grading shortened(double count, const std::vector<LengthDemand>& demands, double slope) const;

 private:
  double eta(double u) const;

  double count_ = 1;
  std::vector<double> u_, eta_, n_;
};

/// The greatest eta' <= eta with |d eta' / du| <= slope, at the same u: neighbouring elements differ by at most the
/// factor exp(slope).
std::vector<double> limited(const std::vector<double>& u, std::vector<double> eta, double slope);

}  // namespace quadrille::sizing
