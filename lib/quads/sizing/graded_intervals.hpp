#pragma once
// Intervals that grow smoothly from given neighbours towards a prescribed size.

#include <vector>

namespace quadrille::sizing {

/// The intervals on both sides of the length to be divided; 0: none, the end is free.
struct GradedEnds {
  double before = 0, after = 0;
  bool are_free() const { return before <= 0 && after <= 0; }
};

/// `count` lengths that sum to `length`. From one end, after i steps, the length is
///   F_i = cap h q^i / (cap + h (q^i - 1)),
/// h the neighbour there: growth by q at most, saturating at `cap`. Between two neighbours, with x = i / (count + 1),
/// F_i^(1-x) B_i^x, B the same from the other end. q follows from the sum and may be below 1; the result depends
/// smoothly on all arguments. Equal lengths between free ends.
std::vector<double> graded_intervals(const GradedEnds& ends, int count, double length, double cap);

/// Greatest ratio of two neighbouring intervals, the given ones included, larger over smaller: at least 1.
double worst_growth(const GradedEnds& ends, const std::vector<double>& intervals);
/// The least count for which no interval exceeds `cap` and none is more than `growth` times its neighbour. At most
/// `most`.
int least_graded_count(const GradedEnds& ends, double length, double cap, double growth, int most);

}  // namespace quadrille::sizing
