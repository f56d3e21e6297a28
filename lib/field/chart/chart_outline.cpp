#include "chart/chart_outline.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "base/error.hpp"
#include "chart/element_tables.hpp"
#include "chart/smooth_parameters.hpp"
#include "chart/tip_angle.hpp"
#include "curve/nurbs.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_map.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr int fit_degree = 7;
constexpr double least_outline = 1e-9;  // tolerance of splines, diameters
/// Samples that each span of a spline needs, also of a straight edge, and the greatest number of bisections.
constexpr int samples_per_span = 8, most_rounds = 24;

struct Samples : CurveSamples {
  std::vector<std::size_t> vertices;  ///< those of `points` that are vertices of the mesh
  Vec3 start_normal;
  Vec2 start_uv;
};

/// t0, the different knots inside (t0, t1), t1. Knots that are an end but for rounding are left out.
std::vector<double> breaks_between(const std::vector<double>& knots, double t0, double t1) {
  const double rounding = 1e-14 * (knots.back() - knots.front());
  std::vector<double> breaks{t0};
  for (const double knot : knots)
    if (knot > breaks.back() + rounding && knot < t1 - rounding) breaks.push_back(knot);
  breaks.push_back(t1);
  return breaks;
}

class ImageSampler {
 public:
  ImageSampler(const SurfaceMesh& mesh, const std::vector<SpaceLength>& lengths)
      : mesh_(&mesh), lengths_(&lengths), tables_(&element_tables(mesh.order)) {}

  std::vector<Samples> samples() const {
    std::vector<Samples> all(lengths_->size());
    for (const BoundaryEdge& edge : mesh_->plane.boundary_edges) add(edge, all[edge.curve]);
    if (mesh_->order == 1)
      for (Samples& s : all) estimate_derivatives(s);
    return all;
  }

 private:
  Vec2 image(const BoundaryEdge& edge, const Eigen::RowVectorXd& weights) const {
    const std::size_t first = static_cast<std::size_t>(mesh_->nodes_per_elem()) * edge.elem;
    Vec2 sum;
    for (Eigen::Index i = 0; i < weights.size(); ++i) sum += weights[i] * mesh_->image[first + i];
    return sum;
  }

  void add(const BoundaryEdge& edge, Samples& samples) const {
    const SpaceLength& length = (*lengths_)[edge.curve];
    const double s0 = length.at(edge.t0), s1 = length.at(edge.t1);
    const auto image_at = [&](double s) {
      return image(edge, node_functions(*tables_, spectral::tri_edge_point(edge.edge, (s - s0) / (s1 - s0))));
    };
    const std::size_t first = static_cast<std::size_t>(mesh_->nodes_per_elem()) * edge.elem;
    const bool is_first = samples.points.empty();
    if (is_first) samples.points.push_back({edge.t0, image_at(s0)}), samples.vertices.push_back(0);
    // Each span between knots has its own, however short it is: a spline with knots there is else not determined, and
    // where the curve bends, so does its image. Elsewhere four for each node: enough to halve spans.
    const std::vector<double> breaks = breaks_between(length.curve().knots, edge.t0, edge.t1);
    const int n = breaks.size() > 2 ? samples_per_span : std::max(samples_per_span, 4 * mesh_->order);
    for (std::size_t b = 1; b < breaks.size(); ++b) {
      const double low = length.at(breaks[b - 1]), high = length.at(breaks[b]);
      for (int i = 1; i < n; ++i) {
        const double s = low + (1 - std::cos(pi * i / n)) / 2 * (high - low);
        samples.points.push_back({length.parameter(s), image_at(s)});
      }
      samples.points.push_back({breaks[b], image_at(high)});
    }
    samples.vertices.push_back(samples.points.size() - 1);
    const auto derivative = [&](bool at_end) {
      const double speed = norm(surface::derivatives(length.curve(), at_end ? edge.t1 : edge.t0, at_end)[1]);
      return image_slope(*mesh_, edge, at_end) * (speed / (s1 - s0));
    };
    if (is_first) {
      samples.start_derivative = derivative(false);
      samples.start_normal = mesh_->normals[first + edge.edge], samples.start_uv = mesh_->uv[first + edge.edge];
    }
    samples.end_derivative = derivative(true);
  }

  // Of straight triangles: those of parabolas through three vertices.
  void estimate_derivatives(Samples& s) const {
    const std::size_t count = s.vertices.size();
    if (count < 3) return;
    const auto at_end = [&](std::size_t i, std::size_t j, std::size_t k) {
      const curve::FitPoint &a = s.points[s.vertices[i]], &b = s.points[s.vertices[j]], &c = s.points[s.vertices[k]];
      const auto slope = [](const curve::FitPoint& from, const curve::FitPoint& to) {
        return (to.position - from.position) / (to.parameter - from.parameter);
      };
      return slope(a, b) + (slope(a, b) - slope(b, c)) * ((b.parameter - a.parameter) / (c.parameter - a.parameter));
    };
    s.start_derivative = at_end(0, 1, 2), s.end_derivative = at_end(count - 1, count - 2, count - 3);
  }

  const SurfaceMesh* mesh_;
  const std::vector<SpaceLength>* lengths_;
  const ElementTables* tables_;
};

/// The ends of the curve in space and its knots, as smooth in a spline of the degree of the fit; none inside where it
/// is as smooth as that spline is at a single knot: the fit has knots of its own.
std::vector<curve::FitKnot> knots_of(const SpaceCurve& curve) {
  std::vector<curve::FitKnot> knots;
  for (const double t : curve.knots) {
    if (knots.empty() || t > knots.back().parameter) knots.push_back({t, 0});
    ++knots.back().multiplicity;
  }
  for (curve::FitKnot& knot : knots)
    knot.multiplicity = std::clamp(fit_degree - curve.degree + knot.multiplicity, 1, fit_degree);
  std::erase_if(knots, [&](const curve::FitKnot& knot) {
    return knot.multiplicity == 1 && knot.parameter > curve.begin() && knot.parameter < curve.end();
  });
  return knots;
}

/// Halves the spans in which the spline misses a sample by more than the tolerance; returns whether there was one that
/// has enough samples for two.
bool bisect_missed_spans(const Nurbs& spline, const std::vector<curve::FitPoint>& points, double tolerance,
                         std::vector<curve::FitKnot>& knots) {
  std::vector<curve::FitKnot> finer{knots.front()};
  std::size_t next = 0;
  for (std::size_t i = 1; i < knots.size(); ++i) {
    const double a = knots[i - 1].parameter, b = knots[i].parameter, middle = (a + b) / 2;
    double miss = 0;
    int below = 0, above = 0;
    for (; next < points.size() && points[next].parameter <= b; ++next) {
      miss = std::max(miss, distance(points[next].position, curve::point(spline, points[next].parameter)));
      ++(points[next].parameter < middle ? below : above);
    }
    if (miss > tolerance && std::min(below, above) >= samples_per_span) finer.push_back({middle, 1});
    finer.push_back(knots[i]);
  }
  const bool is_finer = finer.size() > knots.size();
  knots = std::move(finer);
  return is_finer;
}

/// Knots of a periodic spline, more of them than the degree. It is as smooth at the seam as at the roughest knot
/// inside.
std::vector<curve::FitKnot> periodic_knots(std::vector<curve::FitKnot> knots,
                                           const std::vector<curve::FitPoint>& points) {
  int of_seam = 1;
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) of_seam = std::max(of_seam, knots[i].multiplicity);
  if (of_seam == 1 && knots.size() <= fit_degree + 1) knots = {knots.front(), knots.back()};
  knots.front().multiplicity = knots.back().multiplicity = std::min(of_seam, fit_degree - 1);
  while (knots.size() <= fit_degree + 1) {
    std::vector<curve::FitKnot> finer{knots.front()};
    for (std::size_t i = 1; i < knots.size(); ++i) {
      finer.push_back({(knots[i - 1].parameter + knots[i].parameter) / 2, 1});
      finer.push_back(knots[i]);
    }
    knots = std::move(finer);
  }
  return points.size() > 2 * knots.size() ? knots : std::vector<curve::FitKnot>{};
}

/// Least squares with knots where the tolerance asks for them.
class OutlineFit {
 public:
  OutlineFit(const CurveSamples& samples, const curve::FitEnds& ends, double tolerance)
      : samples_(&samples), ends_(ends), tolerance_(tolerance) {}

  std::optional<Nurbs> open(const std::vector<curve::FitKnot>& knots) const {
    return refined(knots,
                   [&](const auto& k) { return curve::least_squares_spline(fit_degree, k, samples_->points, ends_); });
  }
  std::optional<Nurbs> periodic(const std::vector<curve::FitKnot>& knots) const {
    if (knots.empty()) return std::nullopt;
    return refined(
        knots, [&](const auto& k) { return curve::periodic_least_squares_spline(fit_degree, k, samples_->points); });
  }

 private:
  template <class Fit>
  std::optional<Nurbs> refined(std::vector<curve::FitKnot> knots, const Fit& fit) const {
    std::optional<Nurbs> best;
    for (int round = 0; round < most_rounds; ++round) {
      std::optional<Nurbs> spline = fit(knots);
      if (!spline) break;
      best = std::move(spline);
      if (!bisect_missed_spans(*best, samples_->points, tolerance_, knots)) break;
    }
    return best;
  }

  const CurveSamples* samples_;
  curve::FitEnds ends_;
  double tolerance_;
};

Nurbs fitted(const SpaceCurve& space_curve, const OutlineFit& fit, const CurveSamples& samples, bool is_rough) {
  const std::vector<curve::FitKnot> all = knots_of(space_curve), ends{all.front(), all.back()};
  std::optional<Nurbs> spline;
  if (has_smooth_seam(space_curve)) spline = fit.periodic(periodic_knots(is_rough ? ends : all, samples.points));
  if (!spline && !is_rough) spline = fit.open(all);
  if (!spline) spline = fit.open(ends);
  if (!spline) throw ComputeError("a curve of the boundary is too short for a chart");
  return *std::move(spline);
}

/// The unit tangent at an end; where a curve starts or ends without speed, that of its second derivative.
Vec3 end_direction(const SpaceCurve& curve, bool at_end) {
  constexpr double no_speed = 1e-9;
  const auto [x, d, dd] = surface::derivatives(curve, at_end ? curve.end() : curve.begin(), at_end);
  if (norm(d) > no_speed * norm(dd) * (curve.end() - curve.begin())) return normalized(d);
  return normalized(at_end ? -dd : dd);
}

Vec2 rotated(Vec2 a, double angle) { return a.x * unit(angle) + a.y * left_of(unit(angle)); }

double image_angle(Vec2 in, Vec2 out) { return pi - wrap_pi(angle_of(out) - angle_of(in)); }

/// Turns the derivatives on both sides of a joint, by the same angle, so that it has the angle of space.
void keep_angle(double interior_angle, Vec2& in, Vec2& out) {
  const double missing = wrap_pi(interior_angle - image_angle(in, out));
  in = rotated(in, missing / 2), out = rotated(out, -missing / 2);
}

}  // namespace

double outline_tolerance(double closedness) {
  return std::clamp(closedness / 10, least_outline, rough_outline_tolerance);
}

Nurbs fitted_curve(const SpaceCurve& space_curve, const CurveSamples& samples, double tolerance) {
  const curve::FitEnds ends{samples.points.front().position, samples.start_derivative, samples.points.back().position,
                            samples.end_derivative};
  return fitted(space_curve, OutlineFit(samples, ends, tolerance), samples, false);
}

double space_angle(const SpaceFace& face, int curve, Vec3 normal) {
  const SpaceCurve &before = face.curves[face.face.previous_in_loop(curve)], &after = face.curves[curve];
  const Vec3 in = end_direction(before, true), out = end_direction(after, false);
  return pi - std::atan2(dot(normal, cross(in, out)), dot(in, out));
}

Joint joint_of(const CadFace& face, int curve, double interior_angle, double corner_angle) {
  const Nurbs &before = face.curves[face.previous_in_loop(curve)], &after = face.curves[curve];
  Joint joint;
  joint.position = after.poles.front();
  joint.tangent_in = wrap_pi(angle_of(curve::tangent(before, before.end(), true)));
  joint.tangent_out = wrap_pi(angle_of(curve::tangent(after, after.begin())));
  joint.interior_angle = interior_angle;
  joint.is_corner = std::abs(pi - interior_angle) > corner_angle * (1 + 1e-6);
  return joint;
}

double outline_diameter(const CadFace& face) {
  constexpr int points_per_span = 8;
  std::vector<Vec2> points;
  for (int i = 0; i < face.loop_offsets[1]; ++i)
    curve::for_each_span(face.curves[i], [&](double a, double b) {
      for (int k = 0; k < points_per_span; ++k)
        points.push_back(curve::point(face.curves[i], a + (b - a) * k / points_per_span));
    });
  double most2 = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) most2 = std::max(most2, norm2(points[i] - points[j]));
  return std::sqrt(most2);
}

CadFace outline_of_image(const SpaceFace& space_face, const std::vector<SpaceLength>& lengths, const SurfaceMesh& mesh,
                         const OutlineOptions& options) {
  std::vector<Samples> samples = ImageSampler(mesh, lengths).samples();
  CadFace face = space_face.face;
  std::vector<double> angles;
  for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
    Vec2 &in = samples[face.previous_in_loop(i)].end_derivative, &out = samples[i].start_derivative;
    angles.push_back(tip_angle(space_face, i, samples[i].start_uv, image_angle(in, out))
                         .value_or(space_angle(space_face, i, samples[i].start_normal)));
    keep_angle(angles[i], in, out);
  }
  double size = 0;
  for (const curve::FitPoint& p : samples[0].points)
    for (int i = 0; i < face.loop_offsets[1]; ++i)
      size = std::max(size, distance(p.position, samples[i].points[samples[i].points.size() / 2].position));
  face.curves.clear(), face.joints.clear();
  for (int i = 0; i < static_cast<int>(samples.size()); ++i) {
    const Samples &s = samples[i], &next = samples[space_face.face.next_in_loop(i)];
    const curve::FitEnds ends{s.points.front().position, s.start_derivative, next.points.front().position,
                              s.end_derivative};
    const OutlineFit fit(s, ends, options.tolerance * std::min(size, lengths[i].total()));
    face.curves.push_back(fitted(space_face.curves[i], fit, s, mesh.order == 1));
  }
  for (int i = 0; i < face.num_curves(); ++i) face.joints.push_back(joint_of(face, i, angles[i], options.corner_angle));
  face.diameter = outline_diameter(face);
  face.origin = {};
  face.plane_origin = {0, 0, 0}, face.plane_x = {1, 0, 0}, face.plane_y = {0, 1, 0};
  return face;
}

}  // namespace quadrille::chart
