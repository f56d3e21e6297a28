#pragma once
// Whole numbers nearest to given ones in the norm of a Gram matrix (lib/method.md §8.6, the twists m_j of holes).

#include <Eigen/Dense>
#include <vector>

namespace quadrille::galerkin {

/// m that makes (m - target)^T gram (m - target) small: rounding, then steps by one in one or two entries as long as
/// one of them helps. The best one for a single entry. Halves within 1e-6 are rounded down, and steps that gain less
/// than 1e-6 of the norm are not taken: rounding errors decide nothing.
std::vector<int> nearest_twists(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target);

}  // namespace quadrille::galerkin
