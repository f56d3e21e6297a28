#pragma once
// A given number of elements along a length, with given lengths of the first and the last one.
//
// At the fraction v of the elements the local length of an element is
//
//   l(v) = exp((1 - v) a + v b + k h(v)),    h(v) = sqrt(r^2 + 1/4) - sqrt(r^2 + (v - 1/2)^2),    r = 0.1,
//
// and x(v) = n * integral of l from 0 to v. h rises nearly evenly to the middle and falls likewise, so that the ratio
// of adjacent elements is nearly the same on each half; with a parabola its logarithm at the ends would be almost twice
// as great. a and b follow from the lengths of the first and the last of the n elements, k from the whole length.
// Mirrored ends give mirrored elements. With one end free k is 0: one ratio from element to element.

#include <vector>

namespace quadrille::prescribe {

class LogSpacing {
 public:
  /// `first`, `last`: 0: free; both free: equal elements. Ends that leave no room for other elements, and those of less
  /// than three elements, are reduced. `count` >= 1, `length` > 0.
  LogSpacing(int count, double length, double first, double last);

  /// Ascending from 0 to the length, at equal steps of v.
  const std::vector<double>& positions() const { return positions_; }
  /// l there.
  const std::vector<double>& element_lengths() const { return element_lengths_; }
  /// l at the position x.
  double element_length(double x) const;

 private:
  struct Ends {
    double a = 0, b = 0;
  };
  void sample(const Ends& ends, double bulge);
  void meet_ends(double first, double last, double bulge, Ends& ends);
  void solve_both(double first, double last);
  void solve_one(double first);

  int count_, steps_;  ///< elements, and samples of each
  double length_;
  std::vector<double> positions_, element_lengths_;
};

}  // namespace quadrille::prescribe
