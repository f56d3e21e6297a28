#include "space/surface_kinks.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "base/vec3.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::space {

namespace {

double& along(Vec2& uv, bool is_u) { return is_u ? uv.x : uv.y; }
double along(const Vec2& uv, bool is_u) { return is_u ? uv.x : uv.y; }

/// Knots at which the first derivative may jump.
std::vector<double> break_lines(const std::vector<double>& knots, int degree, bool is_closed) {
  std::vector<double> lines;
  for (auto k = knots.begin() + degree + 1; k + degree + 1 < knots.end(); ++k)
    if (*k != *(k - 1) && std::count(knots.begin(), knots.end(), *k) >= degree) lines.push_back(*k);
  if (is_closed) lines.push_back(knots.front());
  return lines;
}

/// Across a line, and the points of the face on it.
class Line {
 public:
  Line(const RawSpaceFace& raw, bool is_u, double parameter)
      : raw_(raw), is_u_(is_u), parameter_(parameter), knots_(is_u ? raw.surface.knots_u : raw.surface.knots_v) {}

  SurfaceKink greatest() {
    SurfaceKink kink{is_u_, parameter_, 0, {}};
    for (const Vec2& uv : points()) {
      const double angle = angle_at(uv);
      if (angle > kink.angle) kink.angle = angle, kink.position = surface::point(raw_.surface, uv);
    }
    return kink;
  }

 private:
  double range() const { return knots_.back() - knots_.front(); }
  bool is_on(const Vec2& uv) const { return std::abs(along(uv, is_u_) - parameter_) <= 1e-9 * range(); }
  bool is_at_seam(const Vec2& uv) const { return std::abs(along(uv, is_u_) - parameter_ - range()) <= 1e-9 * range(); }

  /// In the middle of a side of a triangle on the line, with the face beyond it, or of a triangle that it crosses.
  std::vector<Vec2> points() const {
    std::vector<Vec2> below, above, found;  // sides with the face on one side, and on the other
    for (const auto& corners : raw_.triangle_uv) add_points(corners, below, above, found);
    for (const Vec2& a : below)
      if (std::any_of(above.begin(), above.end(), [&](const Vec2& b) {
            return std::abs(along(a, !is_u_) - along(b, !is_u_)) <= 1e-6 * other_range();
          }))
        found.push_back(a);
    return found;
  }

  double other_range() const {
    const std::vector<double>& knots = is_u_ ? raw_.surface.knots_v : raw_.surface.knots_u;
    return knots.back() - knots.front();
  }

  void add_points(const std::array<Vec2, 3>& corners, std::vector<Vec2>& below, std::vector<Vec2>& above,
                  std::vector<Vec2>& crossed) const {
    double least = std::numeric_limits<double>::infinity(), most = -least;
    for (const Vec2& c : corners) least = std::min(least, along(c, is_u_)), most = std::max(most, along(c, is_u_));
    for (int k = 0; k < 3; ++k) {
      const Vec2 &a = corners[k], &b = corners[(k + 1) % 3];
      if ((is_on(a) && is_on(b)) || (is_at_seam(a) && is_at_seam(b)))
        (most > std::max(along(a, is_u_), along(b, is_u_)) + 1e-9 * range() ? above : below).push_back(0.5 * (a + b));
    }
    if (least < parameter_ - 1e-9 * range() && most > parameter_ + 1e-9 * range()) {
      Vec2 middle = (corners[0] + corners[1] + corners[2]) / 3.0;
      along(middle, is_u_) = parameter_;
      crossed.push_back(middle);
    }
  }

  Vec3 normal_beside(Vec2 uv, double offset) const {
    double t = parameter_ + offset;
    if (t < knots_.front()) t += range();
    along(uv, is_u_) = t;
    const auto p = surface::evaluate(raw_.surface, uv);
    return cross(p.xu, p.xv);
  }

  double angle_at(const Vec2& uv) const {
    constexpr double beside = 1e-7;  // of the range: a smooth surface turns by less than the angles that matter
    const Vec3 a = normal_beside(uv, -beside * range()), b = normal_beside(uv, beside * range());
    return std::atan2(norm(cross(a, b)), dot(a, b));
  }

  const RawSpaceFace& raw_;
  bool is_u_;
  double parameter_;
  const std::vector<double>& knots_;
};

}  // namespace

std::optional<SurfaceKink> kink_inside(const RawSpaceFace& raw, double angle) {
  const NurbsSurface& s = raw.surface;
  for (const bool is_u : {true, false})
    for (const double t :
         is_u ? break_lines(s.knots_u, s.degree_u, s.is_closed_u) : break_lines(s.knots_v, s.degree_v, s.is_closed_v)) {
      const SurfaceKink kink = Line(raw, is_u, t).greatest();
      if (kink.angle > angle) return kink;
    }
  return std::nullopt;
}

}  // namespace quadrille::space
