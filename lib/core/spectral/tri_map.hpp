#pragma once
// The element map X_e of one triangle, from the reference triangle to the plane, affine or of order N, and its nodes.

#include <array>
#include <vector>

#include "base/vec2.hpp"

namespace quadrille::spectral {

// Interpolation points of the reference triangle, Gauss-Lobatto-Legendre on each edge (Warburton 2006, warp & blend).
// Ranking: the three vertices (-1,-1), (1,-1), (-1,1); then the inner nodes of edges 0, 1, 2, each from local vertex k
// to k+1; then the interior nodes.

/// (N+1)(N+2)/2 points, N >= 1. Computed once per order; the reference stays valid until the program ends.
const std::vector<Vec2>& tri_nodes(int order);

/// Index into tri_nodes(order) of node j = 0..N of local edge `edge`, counted from vertex edge to vertex edge+1.
int tri_edge_node(int order, int edge, int j);

class TriMap {
 public:
  /// The affine map onto a triangle (vertices counter-clockwise).
  explicit TriMap(const std::array<Vec2, 3>& vertices);
  /// The map of order N through geometry nodes at tri_nodes(order).
  TriMap(int order, const Vec2* nodes);

  bool is_affine() const { return order_ == 1; }
  int order() const { return order_; }
  Vec2 position(Vec2 xi) const;
  /// Position and d x / d xi.
  void evaluate(Vec2 xi, Vec2& x, Mat2& dx_dxi) const;
  /// Sets xi to the reference coordinates of a physical point by Newton's method from the given `xi`; (-1/3, -1/3) is
  /// the centroid. Returns false if it did not converge; the result may lie outside the reference triangle.
  bool invert(Vec2 x, Vec2& xi) const;
  /// Coefficients of x and y in the orthogonal basis of degree order().
  const std::vector<double>& coefs_x() const { return coefs_x_; }
  const std::vector<double>& coefs_y() const { return coefs_y_; }

 private:
  void set_affine(const Vec2* vertices);

  int order_ = 1;
  std::vector<double> coefs_x_, coefs_y_;
  Vec2 centre_;    ///< affine only: the image of xi = (0, 0), the middle of edge 1
  Mat2 jacobian_;  ///< affine only
};

/// The reference coordinates of the point at fraction s in [0, 1] of local edge k, from vertex k to vertex k + 1.
Vec2 tri_edge_point(int edge, double s);

}  // namespace quadrille::spectral
