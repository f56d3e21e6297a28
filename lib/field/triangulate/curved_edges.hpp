#pragma once
// Element edges of order N on curves: the interpolant through the Gauss-Lobatto-Legendre points of the arc length, and
// its error.
//
// Curves the boundary elements of a straight-sided mesh. An element with curved edges becomes
//   x(xi) = affine(xi) + sum over curved edges  lambda_a lambda_b q(lambda_b - lambda_a),
// q the polynomial of degree N - 2 that puts the edge's Gauss-Lobatto-Legendre points on the curve. The map is a
// polynomial of degree N, and straight edges stay exactly straight.

#include <Eigen/Dense>
#include <array>
#include <vector>

#include "model/cad_face.hpp"
#include "model/tri_mesh.hpp"
#include "triangulate/outline.hpp"

namespace quadrille::triangulate {

/// A piece of a curve parametrised by the fraction of its arc length: s(t) is the integral of a Chebyshev interpolant
/// of the speed |dx/dt|. curve::ArcLength is the equivalent for a whole curve; this table is twenty times faster for
/// many points of one element edge.
class ArcLengthTable {
 public:
  /// t0 < t1. The piece is divided at knots and where the interpolant is not accurate to round-off.
  ArcLengthTable(const Nurbs& curve, double t0, double t1);

  double length() const { return spans_.back().end; }
  /// The parameter at `fraction` in [0, 1] of the length.
  double parameter(double fraction) const;

 private:
  static constexpr int degree = 16;
  struct Span {
    double t0 = 0, t1 = 0;
    double begin = 0, end = 0;                ///< arc length from the beginning of the piece
    std::array<double, degree + 2> length{};  ///< Chebyshev coefficients of s on the span, 0 at t0
  };
  void add_span(const Nurbs& curve, double t0, double t1, double noise, int depth);

  std::vector<Span> spans_;
};

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

/// Computes the geometry nodes of all elements with an edge on a curve that is not straight: sets mesh.curved_elems and
/// mesh.curved_nodes.
void curve_elements(const EdgeFit& fit, TriMesh& mesh);

/// For each element, a proved lower bound of det(d x / d xi) divided by the determinant of its straight triangle.
std::vector<double> jacobian_ratio_bounds(const TriMesh& mesh);

}  // namespace quadrille::triangulate
