#pragma once
// Moves the ends of intervals so that adjacent intervals differ little, for given counts.
//
// With d_k the lengths of intervals and g the logarithm of the limit, the ends minimise
//
//   sum over adjacent intervals  r^2 + r^4 / (2 g^2),                r = ln d' / d
//   + excess.weight  sum over adjacent intervals max(0, |r| - excess.aim g)^2
//   + weight_shape  sum over intervals (ln d / d_0)^2,               d_0 their lengths at first
//   + weight_skew   sum over opposite ends (slope of the line between them)^2
//
// by Gauss-Newton steps with a sparse factorisation, as far as numbers are finite. The second term, whose weight may be
// 0, shares among many intervals what a few exceed the limit by. The third keeps gradings that are smooth already; the
// fourth keeps lines across narrow blocks nearly normal to their long sides. The ends of arcs, layers and breaks of the
// boundary at which intervals end do not move.

#include <memory>

#include "growth/growth_input.hpp"

namespace quadrille::growth {

/// Fractions of an arc that differ by less are the same.
inline constexpr double same_fraction = 1e-9;

/// Fractions of an arc at which intervals may have to end: breaks of CAD curves, and joints of given names.
std::vector<double> fixed_fractions(const GrowthInput& input, int arc);

/// The weight of ratios whose logarithm exceeds `aim` times that of the limit; 0: none.
struct Excess {
  double weight = 0;
  double aim = 1;
};

/// The problem for divisions with the counts of `shape`, which have d_0: its matrix is analysed once.
class DivisionSmoother {
 public:
  /// What `input` refers to must outlive the smoother.
  DivisionSmoother(const GrowthInput& input, const sizing::ArcDivisions& shape);
  ~DivisionSmoother();

  /// Changes the ends in `divisions`, not their number.
  void smooth(const Excess& excess, sizing::ArcDivisions& divisions);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace quadrille::growth
