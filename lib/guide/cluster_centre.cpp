#include "guide/cluster_centre.hpp"

#include <cmath>
#include <complex>
#include <vector>

#include "base/angle.hpp"

namespace quadrille::guide {
namespace {

using Complex = std::complex<double>;

constexpr int num_samples = 128;

/// w on the circle, conjugated for a negative index; std::nullopt if the circle is not inside the mesh.
std::optional<std::vector<Complex>> samples(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                            bool is_conjugate) {
  std::vector<Complex> result;
  for (int i = 0; i < num_samples; ++i) {
    Vec2 v;
    if (!evaluator.value_at(centre + radius * unit(2 * pi * i / num_samples), v)) return {};
    result.emplace_back(v.x, is_conjugate ? -v.y : v.y);
  }
  return result;
}

Complex coefficient(const std::vector<Complex>& w, int k) {
  Complex sum = 0;
  for (int i = 0; i < num_samples; ++i) sum += w[i] * std::polar(1.0, -2 * pi * ((i * k) % num_samples) / num_samples);
  return sum / static_cast<double>(num_samples);
}

double power(const std::vector<Complex>& w) {
  double sum = 0;
  for (const Complex value : w) sum += std::norm(value);
  return sum / num_samples;
}

/// One step to the centroid from samples about z0; std::nullopt if the index's own term does not outweigh the others.
std::optional<Vec2> step(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double radius) {
  const auto w = samples(evaluator, centre, radius, index < 0);
  if (!w) return {};
  const int n = std::abs(index);
  const Complex leading = coefficient(*w, n);
  if (!(std::norm(leading) > 0.9 * power(*w))) return {};
  const Complex shift = -coefficient(*w, n - 1) * radius / (static_cast<double>(n) * leading);
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
