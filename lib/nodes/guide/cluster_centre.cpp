#include "guide/cluster_centre.hpp"

#include <cmath>
#include <cstdlib>

#include "guide/circle_samples.hpp"

namespace quadrille::guide {
namespace {

double power(const std::vector<Complex>& w) {
  double sum = 0;
  for (const Complex value : w) sum += std::norm(value);
  return sum / static_cast<double>(w.size());
}

/// One step to the centroid from samples about z0; std::nullopt if the index's own term does not outweigh the others.
std::optional<Vec2> step(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double radius) {
  const auto w = circle_samples(evaluator, centre, radius, index);
  if (!w) return {};
  const int n = std::abs(index);
  const Complex leading = fourier_coefficient(*w, n);
  if (!(std::norm(leading) > 0.9 * power(*w))) return {};
  const Complex shift = -fourier_coefficient(*w, n - 1) * radius / (static_cast<double>(n) * leading);
  return Vec2{shift.real(), shift.imag()};
}

/// Repeats the step, because terms of higher order shift the result away from the centroid.
std::optional<Vec2> centroid(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double radius) {
  for (int round = 0; round < 8; ++round) {
    const auto shift = step(evaluator, centre, index, radius);
    if (!shift) return {};
    centre += *shift;
    if (norm(*shift) < 1e-14 * radius) break;
  }
  return centre;
}

}  // namespace

std::optional<Vec2> moment_centre(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double inner,
                                  double outer) {
  for (double radius = outer; radius >= inner; radius *= 0.8) {
    const auto found = centroid(evaluator, centre, index, radius);
    if (found && distance(*found, centre) <= inner) return found;
  }
  return {};
}

}  // namespace quadrille::guide
