#pragma once
// The modified basis expanded in the orthogonal one.

#include <Eigen/Dense>

namespace quadrille::spectral {

/// Row m: the coefficients of mode m in the orthogonal basis of the same order. Computed once per order.
const Eigen::MatrixXd& modified_to_orthogonal(int order);

}  // namespace quadrille::spectral
