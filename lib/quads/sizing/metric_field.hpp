#pragma once
// A metric, prescribed at scattered points: lengths of element edges that differ by direction.
//
// Between the points the logarithms of the tensors are averaged, with weights (1 - d^2 / R^2)^2 at the distance d < R
// from x, R 1.5 times the distance of the sixth-nearest point: over a few points, however far they lie apart. The mean
// of positive definite tensors is so, and a symmetric cloud of points gives a symmetric metric. Beyond the points it is
// that of the nearest ones.

#include <memory>
#include <vector>

#include "base/symmetric_tensor.hpp"
#include "model/alignment.hpp"

namespace quadrille::sizing {

class MetricField {
 public:
  /// `samples`: at least one, lengths > 0; those in one place count as their mean. `slope`: lengths are reduced until
  /// those at neighbouring points, in the same direction, differ by at most slope times the distance. O(n log n).
  MetricField(const std::vector<MetricSample>& samples, double slope);

  /// Of the square root of the metric, whose eigenvalues are 1 / h1 and 1 / h2: the logarithm. O(log n).
  SymmetricTensor logarithm(Vec2 x) const;

 private:
  class Tree;
  std::shared_ptr<const Tree> tree_;
  std::vector<SymmetricTensor> logarithms_;  ///< by point of the tree

  void limit_growth(double slope);
};

}  // namespace quadrille::sizing
