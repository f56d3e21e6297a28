#include "chart/tip_angle.hpp"

#include <cmath>

#include "chart/surface_mesh.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr double part = 1e-4, same_normal = 1e-2;  // of the curve, radians
constexpr int steps = 1000;

/// The directions of the surface around a pole.
class Pole {
 public:
  Pole(const SpaceFace& face, Vec2 uv) : surface_(face.surface), at_(corner_parameters(face, uv)) {}

  bool is_pole() const { return !(at_.has_u && at_.has_v); }
  /// Of a point of the curve near its end at the pole.
  Vec2 beside(const SpaceCurve& curve, double at) const {
    const Vec3 x = surface::point(curve, curve.begin() + at * (curve.end() - curve.begin()));
    return surface::project(surface_, x, at_.uv).uv;
  }
  double angle(Vec2 from, Vec2 to, double rough) const {
    const double inside = swept(around(from), around(to));
    const bool is_closed = at_.has_u ? surface_.is_closed_v : surface_.is_closed_u;
    if (!is_closed) return inside;
    const std::vector<double>& knots = at_.has_u ? surface_.knots_v : surface_.knots_u;
    const double outside = swept(knots.front(), knots.back()) - inside;
    return std::abs(outside - rough) < std::abs(inside - rough) ? outside : inside;
  }

 private:
  double around(Vec2 uv) const { return at_.has_u ? uv.y : uv.x; }
  Vec3 direction(double t) const {
    const surface::SurfacePoint p = surface::evaluate(surface_, at_.has_u ? Vec2{at_.uv.x, t} : Vec2{t, at_.uv.y});
    return normalized(at_.has_u ? p.xu : p.xv);
  }
  double swept(double from, double to) const {
    double sum = 0;
    for (int i = 0; i < steps; ++i)
      sum += distance(direction(from + (to - from) * i / steps), direction(from + (to - from) * (i + 1) / steps));
    return sum;
  }

  const NurbsSurface& surface_;
  CornerParameters at_;
};

}  // namespace

std::optional<double> tip_angle(const SpaceFace& face, int curve, Vec2 uv, double rough) {
  const Pole pole(face, uv);
  if (!pole.is_pole()) return std::nullopt;
  const Vec2 in = pole.beside(face.curves[face.face.previous_in_loop(curve)], 1 - part),
             out = pole.beside(face.curves[curve], part);
  if (norm(face_normal(face, in) - face_normal(face, out)) <= same_normal) return std::nullopt;
  return pole.angle(in, out, rough);
}

}  // namespace quadrille::chart
