#pragma once
// Interpolation of the nodes of elements along a line.

#include <algorithm>
#include <utility>
#include <vector>

namespace quadrille::mesh {

/// Interpolation of y over rising x by the polynomial of each element's nodes.
class PiecewisePolynomial {
 public:
  PiecewisePolynomial(std::vector<double> x, std::vector<double> y, int order)
      : x_(std::move(x)), y_(std::move(y)), order_(order) {}

  double operator()(double x) const {
    const std::size_t node = std::lower_bound(x_.begin(), x_.end(), x) - x_.begin();
    const std::size_t first = std::min((std::max<std::size_t>(node, 1) - 1) / order_ * order_, x_.size() - 1 - order_);
    double result = 0;
    for (int i = 0; i <= order_; ++i) {
      double basis = 1;
      for (int k = 0; k <= order_; ++k)
        if (k != i) basis *= (x - x_[first + k]) / (x_[first + i] - x_[first + k]);
      result += basis * y_[first + i];
    }
    return result;
  }

 private:
  std::vector<double> x_, y_;
  int order_;
};

}  // namespace quadrille::mesh
