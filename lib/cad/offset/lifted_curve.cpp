#include "offset/lifted_curve.hpp"

#include <algorithm>
#include <functional>
#include <optional>
#include <vector>

#include "base/error.hpp"
#include "curve/face_boundary.hpp"
#include "curve/least_squares_spline.hpp"
#include "curve/move_ends.hpp"
#include "curve/nurbs.hpp"
#include "offset/wall_chains.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::offset {
namespace {

constexpr int degree = 7, fewest_spans = 8, most_spans = 512, samples_per_span = 12;
constexpr double on_surface = 1e-12;  // diameters

using SpacePoint = std::function<Vec3(double t)>;

/// The spline through the points; `ends`: none if it closes smoothly. Spans are halved until it is within the
/// tolerance.
SpaceCurve fitted(const Nurbs& image, const SpacePoint& at, const std::optional<curve::SpaceFitEnds>& ends,
                  double tolerance) {
  std::optional<SpaceCurve> spline;
  for (int spans = fewest_spans; spans <= most_spans; spans *= 2) {
    const auto parameter = [&](double k) { return image.begin() + (image.end() - image.begin()) * k / spans; };
    std::vector<curve::FitKnot> knots;
    std::vector<curve::SpaceFitPoint> points;
    for (int k = 0; k <= spans; ++k) knots.push_back({k == spans ? image.end() : parameter(k), 1});
    for (int i = 0; i <= spans * samples_per_span; ++i) {
      const double t = i == spans * samples_per_span ? image.end() : parameter(1.0 * i / samples_per_span);
      points.push_back({t, at(t)});
    }
    spline = curve::least_squares_spline(degree, knots, points, ends);
    if (!spline) throw Defect("a curve inside a chart has no spline in space");
    double off = 0;
    for (int i = 0; i < spans * samples_per_span; i += 2) {
      const double t = parameter((i + 0.5) / samples_per_span);
      off = std::max(off, distance(surface::point(*spline, t), at(t)));
    }
    if (off <= tolerance) break;
  }
  return *std::move(spline);
}

}  // namespace

SpaceCurve lifted_curve(const mesh::ChartMap& map, const CadFace& face, const Nurbs& image) {
  std::optional<curve::SpaceFitEnds> ends;
  const auto derivative = [&](double t, bool at_end) {
    const auto [by_x, by_y] = map.derivatives(curve::point(image, t));
    const Vec2 d = curve::derivative(image, t, at_end);
    return d.x * by_x + d.y * by_y;
  };
  if (!curve::has_smooth_seam(image)) ends = {derivative(image.begin(), false), derivative(image.end(), true)};
  // Lifted points wander along the surface by the error of the chart: a smooth curve near them is projected to it.
  const SpaceCurve near = fitted(
      image, [&](double t) { return map.lift(curve::point(image, t)); }, ends,
      offset_constants.fit_tolerance * face.diameter);
  const auto projected = [&](double t) {
    const Vec2 x = curve::point(image, t);
    std::optional<Vec2> uv;
    map.distance_from_surface(surface::point(near, t), x, uv);
    return surface::point(face.chart->surfaces[face.chart->elem_surface[map.locate(x).elem]], *uv);
  };
  SpaceCurve curve = fitted(image, projected, ends, on_surface * face.diameter);
  if (!ends) return curve;
  const curve::FaceBoundary boundary(face);
  const auto end = [&](Vec2 x, Vec3 lifted) {
    const curve::NearestPoint foot = boundary.nearest(x);
    return foot.distance <= offset_constants.tolerance * face.diameter ? map.boundary_point(foot.curve, foot.t)
                                                                       : lifted;
  };
  curve::move_ends(curve.poles, end(image.poles.front(), map.lift(image.poles.front())),
                   end(image.poles.back(), map.lift(image.poles.back())));
  return curve;
}

}  // namespace quadrille::offset
