#pragma once
// Gauss points along the three edges of an element, for the integrals of harmonic polynomials by boundary modes.

#include <Eigen/Dense>

#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "stiffness/harmonic_frame.hpp"

namespace quadrille::stiffness {

/// For elements of order P.
struct EdgeRule {
  spectral::Quadrature rule;
  /// Points x 2 P: the traces of the mode of the first vertex, of that of the last, and of the edge modes of degree
  /// 2 .. P; then the slopes of these edge modes, which are orthonormal.
  Eigen::MatrixXd modes;
};

/// Exact for straight edges; with more points for curved ones. Computed once.
const EdgeRule& edge_rule(int order, bool is_curved);

/// The points of edges 0, 1 and 2, counter-clockwise, and the weights times the derivative of z.
struct EdgePoints {
  Eigen::ArrayXcd z, dz;
};

EdgePoints edge_points(const spectral::TriMap& map, const HarmonicFrame& frame, int order);

}  // namespace quadrille::stiffness
