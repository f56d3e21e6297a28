#include "base/angle_sum.hpp"

#include <algorithm>
#include <array>
#include <cmath>

namespace quadrille {

namespace {

constexpr double least_distance = 3;  // of far points, in radii
constexpr double remainder = 1e-17;
constexpr int max_terms = 36;  // least_distance^-36 < remainder

Vec2 product(Vec2 a, Vec2 b) { return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x}; }

int num_terms(double ratio) {
  return ratio > 0 ? std::min(max_terms, static_cast<int>(std::ceil(std::log(remainder) / std::log(ratio)))) : 1;
}

/// The powers 1, ..., n of a complex number.
struct Powers {
  std::array<double, 2 * max_terms> re, im;

  // Each round doubles the number of powers, so that a compiler vectorises the loop.
  Powers(Vec2 z, int n) {
    re[0] = z.x, im[0] = z.y;
    for (int known = 1; known < n; known *= 2) {
      const double x = re[known - 1], y = im[known - 1];
      const int more = std::min(known, n - known);
      for (int i = 0; i < more; ++i) {
        re[known + i] = x * re[i] - y * im[i];
        im[known + i] = x * im[i] + y * re[i];
      }
    }
  }
};

// -1 / k, k = 1, 2, ...
constexpr std::array<double, max_terms> minus_reciprocals = [] {
  std::array<double, max_terms> values{};
  for (int k = 0; k < max_terms; ++k) values[k] = -1.0 / (k + 1);
  return values;
}();

// Of the sum of the products of two complex numbers each: in four sums, since each addition waits for the one before.
double imaginary_part(const std::vector<double>& re, const std::vector<double>& im, const double* z_re,
                      const double* z_im) {
  constexpr std::size_t width = 4;
  std::array<double, width> sums{};
  std::size_t k = 0;
  for (; k + width <= re.size(); k += width)
    for (std::size_t i = 0; i < width; ++i) sums[i] += re[k + i] * z_im[k + i] + im[k + i] * z_re[k + i];
  for (; k < re.size(); ++k) sums[k % width] += re[k] * z_im[k] + im[k] * z_re[k];
  return (sums[0] + sums[1]) + (sums[2] + sums[3]);
}

}  // namespace

bool AngleExpansion::is_far(Vec2 a, Vec2 b) const {
  const Vec2 along = b - a;
  const double length2 = norm2(along);
  const double f = length2 > 0 ? std::clamp(dot(centre_ - a, along) / length2, 0.0, 1.0) : 0.0;
  return norm2(a + f * along - centre_) >= least_distance * least_distance * radius_ * radius_;
}

// log(1 + z), z = (x - centre) / (centre - a), is the sum of -(-z)^k / k.
void AngleExpansion::add(Vec2 a, Vec2 weight) {
  const Vec2 d = centre_ - a, q = (-radius_ / norm2(d)) * Vec2{d.x, -d.y};
  const int n = num_terms(norm(q));
  const Powers power(q, n);
  const auto add_to = [&](Series& series, double factor) {
    if (factor == 0) return;
    if (series.re.size() < static_cast<std::size_t>(n)) series.re.resize(n, 0), series.im.resize(n, 0);
    for (int k = 0; k < n; ++k) {
      const double scaled = factor * minus_reciprocals[k];
      series.re[k] += scaled * power.re[k];
      series.im[k] += scaled * power.im[k];
    }
  };
  add_to(first_, weight.x);
  add_to(second_, weight.y);
}

// Horner's rule gives the value at the offset as the remainder of a division by (z - offset), and again the first
// derivative from the quotient, and so on.
AngleExpansion::Series AngleExpansion::Series::about(Vec2 offset, double scale) const {
  Series other = *this;
  const auto n = static_cast<int>(re.size());  // the coefficient of power k is number k - 1
  for (int divisions = 0; divisions < n; ++divisions) {
    for (int k = n - 1; k > std::max(divisions - 1, 0); --k) {
      const Vec2 term = product(offset, {other.re[k], other.im[k]});
      other.re[k - 1] += term.x, other.im[k - 1] += term.y;
    }
  }
  double power = 1;
  for (int k = 0; k < n; ++k) {
    power *= scale;
    other.re[k] *= power, other.im[k] *= power;
  }
  return other;
}

AngleExpansion AngleExpansion::inside(Vec2 centre, double radius) const {
  AngleExpansion other(centre, radius);
  const Vec2 offset = (centre - centre_) / radius_;
  if (!first_.re.empty()) other.first_ = first_.about(offset, radius / radius_);
  if (!second_.re.empty()) other.second_ = second_.about(offset, radius / radius_);
  return other;
}

Vec2 AngleExpansion::at(Vec2 x) const {
  const auto n = static_cast<int>(std::max(first_.re.size(), second_.re.size()));
  if (n == 0) return {};
  const Powers z((x - centre_) / radius_, n);
  const auto sum = [&z](const Series& series) {
    return imaginary_part(series.re, series.im, z.re.data(), z.im.data());
  };
  return {sum(first_), sum(second_)};
}

}  // namespace quadrille
