#include "check/nurbs_rules.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace quadrille::check {

std::string structure_fault(const Nurbs& curve) {
  const std::size_t num_poles = curve.poles.size();
  const auto degree = static_cast<std::size_t>(curve.degree);
  if (curve.degree < 1 || curve.degree > 25) return fmt::format("degree {} is outside 1 to 25", curve.degree);
  if (num_poles < degree + 1) return fmt::format("{} poles are too few for degree {}", num_poles, degree);
  if (curve.weights.size() != num_poles) return fmt::format("{} weights for {} poles", curve.weights.size(), num_poles);
  if (curve.knots.size() != num_poles + degree + 1)
    return fmt::format("{} knots for {} poles of degree {}", curve.knots.size(), num_poles, degree);
  return {};
}

namespace {

/// Multiplicity of the knot at position `i`, counted forwards.
std::size_t multiplicity(const std::vector<double>& knots, std::size_t i) {
  std::size_t m = 1;
  while (i + m < knots.size() && knots[i + m] == knots[i]) ++m;
  return m;
}

std::string knot_fault(const Nurbs& curve) {
  const std::vector<double>& knots = curve.knots;
  const auto degree = static_cast<std::size_t>(curve.degree);
  for (std::size_t i = 0; i + 1 < knots.size(); ++i)
    if (!(knots[i] <= knots[i + 1])) return fmt::format("knot {} is smaller than the one before", i + 1);
  if (!(knots.front() < knots.back())) return "the domain is empty";
  if (multiplicity(knots, 0) != degree + 1 || knots[knots.size() - degree - 1] != knots.back())
    return "the curve is not clamped at its ends";
  for (std::size_t i = degree + 1; knots[i] < knots.back(); i += multiplicity(knots, i))
    if (multiplicity(knots, i) > degree) return fmt::format("the curve is broken at knot {}", i);
  return {};
}

/// Largest ratio of weights: beyond it the lightest pole has no influence in double precision near the heaviest one.
constexpr double max_weight_ratio = 1e8;

}  // namespace

std::string number_fault(const Nurbs& curve) {
  for (std::size_t i = 0; i < curve.poles.size(); ++i) {
    if (!std::isfinite(curve.poles[i].x) || !std::isfinite(curve.poles[i].y))
      return fmt::format("pole {} is not finite", i);
    if (!std::isfinite(curve.weights[i]) || curve.weights[i] <= 0) return fmt::format("weight {} is not positive", i);
  }
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    if (!std::isfinite(curve.knots[i])) return fmt::format("knot {} is not finite", i);
  const auto [least, greatest] = std::minmax_element(curve.weights.begin(), curve.weights.end());
  if (*greatest > max_weight_ratio * *least)
    return fmt::format("weights {:.3g} and {:.3g} differ by more than a factor of {:.0g}", *least, *greatest,
                       max_weight_ratio);
  return knot_fault(curve);
}

bool has_far_pole(const Nurbs& curve, const CadFace& face) {
  const Vec2 centre = face.curves.front().poles.front();
  return std::any_of(curve.poles.begin(), curve.poles.end(),
                     [&](Vec2 p) { return !(norm(p - centre) <= 1000 * face.diameter); });
}

Vec2 curve_point(const Nurbs& curve, double t) {
  const auto degree = static_cast<std::size_t>(curve.degree);
  const std::size_t num_poles = curve.poles.size();
  const auto above = std::upper_bound(curve.knots.begin() + curve.degree + 1,
                                      curve.knots.begin() + static_cast<std::ptrdiff_t>(num_poles), t);
  const auto span = static_cast<std::size_t>(above - curve.knots.begin()) - 1;
  struct Homogeneous {
    double x, y, w;
  };
  std::vector<Homogeneous> d(degree + 1);
  for (std::size_t j = 0; j <= degree; ++j) {
    const std::size_t i = span - degree + j;
    const double w = curve.weights[i];
    d[j] = {w * curve.poles[i].x, w * curve.poles[i].y, w};
  }
  for (std::size_t r = 1; r <= degree; ++r)
    for (std::size_t j = degree; j >= r; --j) {
      const double low = curve.knots[span - degree + j], high = curve.knots[span + 1 + j - r];
      const double s = (t - low) / (high - low);
      d[j] = {(1 - s) * d[j - 1].x + s * d[j].x, (1 - s) * d[j - 1].y + s * d[j].y, (1 - s) * d[j - 1].w + s * d[j].w};
    }
  return {d[degree].x / d[degree].w, d[degree].y / d[degree].w};
}

}  // namespace quadrille::check
