#include "placement/minimise.hpp"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <limits>

#include "base/error.hpp"

namespace quadrille::placement {

namespace {

using Eigen::MatrixXd;
using Eigen::VectorXd;

constexpr double difference_step = 1e-5;
constexpr double noise_allowance = 1e4;  // last steps below so many tolerances are the gradient's noise

class Descent {
 public:
  Descent(const Minimand& f, const VectorXd& x, const MinimiseOptions& options) : f_(f), options_(options) {
    found_.x = x;
    const auto sample = evaluate(x);
    if (!sample) throw Defect("a minimum is sought from a point where the function does not exist");
    here_ = *sample;
  }

  Minimum run() {
    found_.is_converged = found_.x.size() == 0;
    double newton_gradient = options_.newton_gradient;
    bool is_first = !options_.begins_with_hessian;
    while (found_.iterations < options_.max_iterations && !found_.is_converged) {
      const bool moves_on = quasi_newton(newton_gradient, is_first);
      is_first = false;
      const bool is_near = newton();
      if (is_near || !moves_on) break;
      newton_gradient /= 30;
    }
    found_.value = here_.value;
    return found_;
  }

 private:
  std::optional<Minimand::Sample> evaluate(const VectorXd& x) {
    ++found_.evaluations;
    return f_.sample(x);
  }

  // Near the end values no longer tell descent from noise; there the slope along the step does.
  bool descends(const Minimand::Sample& next, const VectorXd& step, double slope) const {
    const double noise = 1e-9 * (1 + std::abs(here_.value));
    if (next.value <= here_.value + 1e-4 * slope && slope < -noise) return true;
    return next.value <= here_.value + noise && std::abs(next.gradient.dot(step)) <= std::abs(slope);
  }

  std::optional<Minimand::Sample> search(VectorXd& step) {
    step *= f_.allowed(found_.x, step);
    for (int halving = 0; halving < 40; ++halving, step /= 2) {
      const auto next = evaluate(found_.x + step);
      if (next && descends(*next, step, here_.gradient.dot(step))) return next;
    }
    return std::nullopt;
  }

  void accept(const Minimand::Sample& next, const VectorXd& step) {
    found_.x += step;
    here_ = next;
  }

  // By differences of gradients, forward ones where they exist.
  std::optional<MatrixXd> hessian() {
    const auto n = found_.x.size();
    MatrixXd h(n, n);
    for (Eigen::Index i = 0; i < n; ++i) {
      VectorXd x = found_.x;
      double step = difference_step;
      x[i] += step;
      auto sample = evaluate(x);
      if (!sample) {
        step = -step;
        x[i] = found_.x[i] + step;
        sample = evaluate(x);
      }
      if (!sample) return std::nullopt;
      h.col(i) = (sample->gradient - here_.gradient) / step;
    }
    return (h + h.transpose()) / 2;
  }

  // Curvatures below `clear` cannot be told from none: a flat direction that is bent seems to have up to |g| of it.
  struct Modes {
    Eigen::SelfAdjointEigenSolver<MatrixXd> of;
    double gradient = 0, flat = 0, clear = 0;

    double least() const { return of.eigenvalues()[0]; }
    bool are_decided() const {
      return ((of.eigenvalues().array().abs() <= flat) || (of.eigenvalues().array() > clear)).all();
    }
  };

  std::optional<Modes> modes_here() {
    const auto h = hessian();
    if (!h) return std::nullopt;
    Modes modes;
    modes.of.compute(*h);
    modes.gradient = here_.gradient.norm();
    modes.flat = options_.flat_curvature * modes.of.eigenvalues().cwiseAbs().maxCoeff();
    modes.clear = std::max(modes.flat, 3 * modes.gradient);
    found_.least_curvature = modes.least();
    return modes;
  }

  // Of the Hessian with its curvatures taken positive, so that it leads down.
  MatrixXd inverse_here() {
    const auto modes = modes_here();
    const auto n = found_.x.size();
    if (!modes) return MatrixXd::Identity(n, n);
    const VectorXd curvatures = modes->of.eigenvalues().cwiseAbs().cwiseMax(10 * modes->flat);
    const MatrixXd& vectors = modes->of.eigenvectors();
    return vectors * curvatures.cwiseInverse().asDiagonal() * vectors.transpose();
  }

  // BFGS for the inverse Hessian until the gradient is small; false where no step leads down.
  bool quasi_newton(double small_gradient, bool from_identity) {
    if (here_.gradient.lpNorm<Eigen::Infinity>() <= small_gradient) return true;
    const auto n = found_.x.size();
    MatrixXd inverse = from_identity ? MatrixXd::Identity(n, n) : inverse_here();
    bool is_scaled = !from_identity;
    while (here_.gradient.lpNorm<Eigen::Infinity>() > small_gradient) {
      if (++found_.iterations > options_.max_iterations) return false;
      VectorXd step = -inverse * here_.gradient;
      const auto next = search(step);
      if (!next) return false;
      const VectorXd change = next->gradient - here_.gradient;
      const double bend = step.dot(change);
      accept(*next, step);
      if (bend <= 1e-12 * step.norm() * change.norm()) continue;
      if (!is_scaled) inverse *= bend / change.squaredNorm();
      is_scaled = true;
      const VectorXd image = inverse * change;
      inverse += (1 + change.dot(image) / bend) / bend * step * step.transpose() -
                 (image * step.transpose() + step * image.transpose()) / bend;
    }
    return true;
  }

  // The Newton step in the directions that have curvature.
  VectorXd newton_step(const Modes& modes) const {
    const VectorXd along = modes.of.eigenvectors().transpose() * here_.gradient;
    VectorXd step = VectorXd::Zero(along.size());
    for (Eigen::Index i = 0; i < along.size(); ++i) {
      const double curvature = modes.of.eigenvalues()[i];
      if (curvature > modes.clear) step -= along[i] / curvature * modes.of.eigenvectors().col(i);
    }
    return step;
  }

  // The length of the step, if it can be gone and leads nearer.
  std::optional<double> go(const VectorXd& step) {
    const double length = f_.length(step);
    if (!std::isfinite(length) || f_.allowed(found_.x, step) < 1) return std::nullopt;
    const auto next = evaluate(found_.x + step);
    const bool is_noise = length < noise_allowance * options_.tolerance;
    if (!next || (!is_noise && next->gradient.norm() > here_.gradient.norm())) return std::nullopt;
    accept(*next, step);
    found_.last_step = length;
    return length;
  }

  // With one Hessian as long as steps shrink well; true where a minimum is as near as the gradient's noise allows.
  bool newton() {
    std::optional<Modes> modes;
    double before = std::numeric_limits<double>::infinity();
    for (int stalls = 0; stalls < 3;) {
      if (++found_.iterations > options_.max_iterations) return false;
      if (!modes) modes = modes_here();
      if (!modes || modes->least() < -modes->clear) return false;
      const auto length = go(newton_step(*modes));
      if (!length) return false;
      if (*length <= options_.tolerance) {
        found_.is_converged = modes->are_decided();
        if (found_.is_converged) return true;
        if (here_.gradient.norm() > 0.3 * modes->gradient) return false;
        modes.reset();
      } else if (*length > 0.1 * before) {
        ++stalls;
        modes.reset();
      }
      before = *length;
    }
    return found_.last_step < noise_allowance * options_.tolerance;
  }

  const Minimand& f_;
  const MinimiseOptions& options_;
  Minimum found_;
  Minimand::Sample here_;
};

}  // namespace

Minimum minimise(const Minimand& f, const Eigen::VectorXd& x, const MinimiseOptions& options) {
  return Descent(f, x, options).run();
}

}  // namespace quadrille::placement
