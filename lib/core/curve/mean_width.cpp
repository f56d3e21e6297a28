#include "curve/mean_width.hpp"

#include "curve/gauss.hpp"
#include "curve/nurbs.hpp"

namespace quadrille::curve {

double mean_width(const CadFace& face) {
  double twice_area = 0, length = 0;
  for (const Nurbs& curve : face.curves)
    for (std::size_t k = curve.degree; k < curve.poles.size(); ++k) {
      const double a = curve.knots[k], b = curve.knots[k + 1];
      if (!(a < b)) continue;
      twice_area += gauss_integral<8>([&](double t) { return cross(point(curve, t), derivative(curve, t)); }, a, b);
      length += gauss_integral<8>([&](double t) { return norm(derivative(curve, t)); }, a, b);
    }
  return twice_area / length;
}

}  // namespace quadrille::curve
