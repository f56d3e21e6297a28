#pragma once
// Approximation error of an element edge of order N on a part of a curve. The edge is the interpolant through the
// Gauss-Lobatto-Legendre points of the arc length.

#include <Eigen/Dense>
#include <vector>

#include "triangulate/arc_length_table.hpp"
#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

class EdgeFit {
 public:
  /// `outline` must outlive the fit.
  EdgeFit(const Outline& outline, int order);

  int order() const { return order_; }
  const Outline& outline() const { return *outline_; }
  /// The N - 1 points between the ends of the edge from t0 to t1 on `curve`.
  std::vector<Vec2> inner_nodes(int curve, double t0, double t1) const;
  /// Greatest sampled distance (a length) between the interpolant and the curve, normal to the curve.
  double error(int curve, double t0, double t1) const;
  /// Total absolute change of the tangent angle between t0 and t1, radians, sampled.
  double turn(int curve, double t0, double t1) const;

 private:
  std::vector<Vec2> inner_nodes(const Nurbs& curve, const ArcLengthTable& stretch) const;

  const Outline* outline_;
  int order_;
  std::vector<double> fractions_;         ///< of the arc length, at all nodes
  std::vector<double> sample_fractions_;  ///< of the arc length, between the nodes
  Eigen::MatrixXd samples_;               ///< nodes -> samples
};

}  // namespace quadrille::triangulate
