#pragma once
// Moves the ends of intervals so that adjacent intervals differ little, for given counts.
//
// With d_k the lengths of intervals and g the logarithm of the limit, the ends minimise
//
//   sum over adjacent intervals  r^2 + r^4 / (2 g^2),                r = ln d' / d
//   + excess.weight  sum over adjacent intervals max(0, |r| - excess.aim g)^2
//   + shape_weight   sum over intervals (ln d / d_0)^2,              d_0 their lengths at first
//   + skew_weight    sum over opposite ends (slope of the line between them)^2
//
// by Gauss-Newton steps with a sparse factorisation, as far as numbers are finite. The second term, whose weight may be
// 0, shares among many intervals what a few exceed the limit by. The third keeps gradings that are smooth already; the
// fourth keeps lines across narrow blocks nearly normal to their long sides. The ends of arcs, layers and breaks of the
// boundary at which intervals end do not move.

#include <array>
#include <compare>
#include <memory>
#include <vector>

#include "sizing/measured_layout.hpp"

namespace quadrille::growth {

struct GrowthInput {
  const sizing::MeasuredLayout& measured;
  double limit = 1.3;                           ///< greatest ratio of adjacent intervals that is aimed at, > 1
  int order = 4;                                ///< shape order of the elements
  double tolerance = 0;                         ///< of the boundary, a length
  std::vector<std::array<int, 2>> layers = {};  ///< by arc and end: intervals that do not move; empty: none anywhere
  std::vector<bool> keeps_count = {};           ///< by chord: its count is prescribed; empty: none is

  int num_layers(int arc, int end) const { return layers.empty() ? 0 : layers[arc][end]; }
  bool may_raise(int chord) const { return keeps_count.empty() || !keeps_count[chord]; }
};

/// Interval k of an arc, between its ends k and k + 1.
struct Interval {
  int arc = 0, k = 0;
  auto operator<=>(const Interval&) const = default;
};

struct IntervalPair {
  Interval a, b;
};

/// All pairs of adjacent intervals of which at least one may change: consecutive ones of each arc, then those across
/// nodes, on both sides of an arc between two blocks (mesh/chords). Layers do not change.
std::vector<IntervalPair> adjacent_intervals(const GrowthInput& input, const sizing::ArcDivisions& divisions);

/// Whether an interval is one of the layers at an end of its arc.
bool is_layer(const GrowthInput& input, const sizing::ArcDivisions& divisions, const Interval& interval);

/// ln of the length of b over that of a.
double log_growth(const GrowthInput& input, const sizing::ArcDivisions& divisions, const IntervalPair& pair);

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
