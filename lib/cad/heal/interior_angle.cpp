#include "heal/interior_angle.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/arc_length.hpp"
#include "curve/nurbs.hpp"
#include "heal/heal_rules.hpp"

namespace quadrille::heal {

double interior_angle(const Nurbs& in, const Nurbs& out) {
  const Vec2 a = curve::tangent(in, in.end(), true), b = curve::tangent(out, out.begin());
  const double turn = std::atan2(cross(a, b), dot(a, b));
  if (std::abs(turn) < 1e-9) return pi;
  if (pi - std::abs(turn) > 1e-6) return pi - turn;
  const curve::ArcLength length_in(in), length_out(out);
  const double h = 1e-3 * std::min(length_in.total(), length_out.total());
  const Vec2 joint = out.poles.front();
  const Vec2 back = curve::point(in, length_in.parameter(length_in.total() - h)) - joint;
  const Vec2 ahead = curve::point(out, length_out.parameter(h)) - joint;
  const bool outside = cross(ahead, back) < 0;
  const double deficit = pi - std::abs(turn);
  return outside ? 2 * pi - std::max(deficit, 1e-15) : std::max(deficit, 1e-300);
}

bool is_cusp(double interior_angle) { return interior_angle <= blunt_rules.largest_cusp; }

}  // namespace quadrille::heal
