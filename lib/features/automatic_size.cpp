#include "features/automatic_size.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "base/error.hpp"
#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::features {
namespace {

constexpr double of_diameter = 1.0 / 500;

struct Extent {
  double area = 0, perimeter = 0;
};

Extent extent(const CadFace& face) {
  Extent sum;
  for (const Nurbs& curve : face.curves)
    for (std::size_t k = curve.degree; k < curve.poles.size(); ++k) {
      const double a = curve.knots[k], b = curve.knots[k + 1];
      if (!(a < b)) continue;
      const auto twice_area = [&](double t) { return cross(curve::point(curve, t), curve::derivative(curve, t)); };
      sum.area += curve::gauss_integral<8>(twice_area, a, b) / 2;
      sum.perimeter += curve::gauss_integral<8>([&](double t) { return norm(curve::derivative(curve, t)); }, a, b);
    }
  return sum;
}

}  // namespace

double automatic_feature_size(const CadFace& face) {
  const Extent whole = extent(face);
  return std::min(of_diameter * face.diameter, whole.area / whole.perimeter);
}

std::optional<double> parse_feature_size(const std::string& text) {
  if (text == "auto") return std::nullopt;
  double size = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), size);
  if (error != std::errc() || end != text.data() + text.size() || !(size >= 0) || !std::isfinite(size))
    throw UsageError(fmt::format("--feature-size {}: expected \"auto\" or a length in file units, 0 or above", text));
  return size;
}

}  // namespace quadrille::features
