#pragma once
// The winding of the phase of a field around holes (lib/method.md §8.6).

#include <Eigen/Dense>
#include <vector>

namespace quadrille::galerkin {

/// The hole winding m_j (lib/method.md §8.6): an integer vector m of small (m - target)^T gram (m - target): rounding,
/// then steps of +-1 in one or two entries as long as one of them reduces the norm. For a single entry m is optimal.
/// Halves within 1e-6 are rounded down, and steps whose relative gain is below 1e-6 are rejected, so that rounding
/// errors do not affect the result.
std::vector<int> nearest_hole_winding(const Eigen::MatrixXd& gram, const Eigen::VectorXd& target);

}  // namespace quadrille::galerkin
