#pragma once
// How well an element edge of order N follows a stretch of curve: the interpolant through Gauss-Lobatto-Legendre points
// of the arc length.

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
  /// Greatest sampled distance of the interpolant from the curve, across the curve's direction.
  double error(int curve, double t0, double t1) const;
  /// Sum of the absolute changes of the tangent's angle between t0 and t1, sampled.
  double turn(int curve, double t0, double t1) const;

 private:
  std::vector<Vec2> inner_nodes(const Nurbs& curve, const ArcLengthTable& stretch) const;

  const Outline* outline_;
  int order_;
  std::vector<double> fractions_;         ///< of the arc length, of all nodes
  std::vector<double> sample_fractions_;  ///< between the nodes
  Eigen::MatrixXd samples_;               ///< nodes -> samples
};

}  // namespace quadrille::triangulate
