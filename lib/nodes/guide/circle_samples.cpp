#include "guide/circle_samples.hpp"

#include "base/angle.hpp"

namespace quadrille::guide {
namespace {

constexpr int num_samples = 128;

}  // namespace

std::optional<std::vector<Complex>> circle_samples(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                   int index) {
  std::vector<Complex> result;
  for (int i = 0; i < num_samples; ++i) {
    Vec2 v;
    if (!evaluator.value_at(centre + radius * unit(2 * pi * i / num_samples), v)) return {};
    result.emplace_back(v.x, index < 0 ? -v.y : v.y);
  }
  return result;
}

Complex fourier_coefficient(const std::vector<Complex>& w, int k) {
  const int n = static_cast<int>(w.size());
  Complex sum = 0;
  for (int i = 0; i < n; ++i) sum += w[i] * std::polar(1.0, -2 * pi * ((i * k) % n) / n);
  return sum / static_cast<double>(n);
}

std::vector<Complex> analytic_part(const std::vector<Complex>& w) {
  const int n = static_cast<int>(w.size());
  std::vector<Complex> coefficients, part;
  for (int k = 0; k < n / 2; ++k) coefficients.push_back(fourier_coefficient(w, k));
  for (int i = 0; i < n; ++i) {
    const Complex zeta = std::polar(1.0, 2 * pi * i / n);
    Complex sum = 0;
    for (int k = n / 2; k-- > 0;) sum = sum * zeta + coefficients[k];
    part.push_back(sum);
  }
  return part;
}

}  // namespace quadrille::guide
