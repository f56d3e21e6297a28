#pragma once
// Functions whose minima are known, for the tests of the minimiser.

#include <Eigen/Core>
#include <functional>
#include <optional>
#include <utility>

#include "placement/minimise.hpp"

namespace quadrille::placement {

/// Steps of any length are allowed.
inline Minimand unbounded(std::function<std::optional<Minimand::Sample>(const Eigen::VectorXd&)> sample) {
  return {std::move(sample), [](const Eigen::VectorXd&, const Eigen::VectorXd&) { return 1.0; },
          [](const Eigen::VectorXd& step) { return step.norm(); }};
}

/// The matrix of a quadratic function with curvatures 1 and 3 along the diagonals.
inline const Eigen::Matrix2d tilted{{2, 1}, {1, 2}};

/// (x - centre)^T A (x - centre) / 2.
inline Minimand quadratic(const Eigen::MatrixXd& a, const Eigen::VectorXd& centre) {
  return unbounded([=](const Eigen::VectorXd& x) {
    const Eigen::VectorXd slope = a * (x - centre);
    return Minimand::Sample{(x - centre).dot(slope) / 2, slope};
  });
}

/// A descent that stands at x, where the function must exist; the function and the options must outlive it.
inline Descent descent_from(const Minimand& f, const MinimiseOptions& options, const Eigen::VectorXd& x) {
  Descent descent{f, options, {}, f.sample(x).value()};
  descent.found.x = x;
  return descent;
}

}  // namespace quadrille::placement
