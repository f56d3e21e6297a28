#include "check/rules.hpp"

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
    if (!is_finite(curve.poles[i])) return fmt::format("pole {} is not finite", i);
    if (!is_finite(curve.weights[i]) || curve.weights[i] <= 0) return fmt::format("weight {} is not positive", i);
  }
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    if (!is_finite(curve.knots[i])) return fmt::format("knot {} is not finite", i);
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

}  // namespace quadrille::check
