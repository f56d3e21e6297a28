#include "base/angle_expansion.hpp"

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
  const auto n = static_cast<std::size_t>(num_terms(std::sqrt(norm2(q))));
  if (first_.re.size() < n)
    for (std::vector<double>* part : {&first_.re, &first_.im, &second_.re, &second_.im}) part->resize(n, 0);
  Vec2 power{-1, 0};
  for (std::size_t k = 0; k < n; ++k) {
    power = product(power, q);
    const Vec2 term = power / static_cast<double>(k + 1);
    first_.re[k] += weight.x * term.x, first_.im[k] += weight.x * term.y;
    second_.re[k] += weight.y * term.x, second_.im[k] += weight.y * term.y;
  }
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
  if (first_.re.empty()) return other;
  const Vec2 offset = (centre - centre_) / radius_;
  other.first_ = first_.about(offset, radius / radius_);
  other.second_ = second_.about(offset, radius / radius_);
  return other;
}

Vec2 AngleExpansion::at(Vec2 x) const {
  const auto n = static_cast<int>(first_.re.size());
  if (n == 0) return {};
  const Powers z((x - centre_) / radius_, n);
  Vec2 sum;
  for (int k = n - 1; k >= 0; --k) {
    sum.x += first_.re[k] * z.im[k] + first_.im[k] * z.re[k];
    sum.y += second_.re[k] * z.im[k] + second_.im[k] * z.re[k];
  }
  return sum;
}

}  // namespace quadrille
