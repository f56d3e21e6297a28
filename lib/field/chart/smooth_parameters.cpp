#include "chart/smooth_parameters.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include "base/angle.hpp"
#include "chart/space_length.hpp"
#include "curve/least_squares_spline.hpp"
#include "surface/nurbs_surface.hpp"

namespace quadrille::chart {
namespace {

constexpr int degree = 7, smooth_derivatives = 3, fewest_spans = 8, most_spans = 256, most_fits = 24,
              samples_per_fit_span = 12;
constexpr double fit_tolerance = 1e-13, worst_fit = 1e-12;  ///< of the length of the curve
constexpr double same_direction = 1e-7, same_slope = 1e-2;  ///< of tangent and curvature, and of the curvature's slope

/// Tangent, curvature vector, and its derivative by arc length, which is a difference.
struct Bend {
  Vec3 tangent, curvature, slope;
};

Vec3 curvature_at(const SpaceCurve& curve, double t, bool from_left) {
  const auto [x, d, dd] = surface::derivatives(curve, t, from_left);
  return (dd - dot(dd, d) / norm2(d) * d) / norm2(d);
}

/// `span`: length of the knot span on this side.
Bend bend_at(const SpaceCurve& curve, double t, bool from_left, double span) {
  constexpr double part = 1e-3;
  const double step = from_left ? -part * span : part * span;
  const Vec3 d = surface::derivatives(curve, t, from_left)[1];
  const Vec3 here = curvature_at(curve, t, from_left), there = curvature_at(curve, t + step, from_left);
  return {normalized(d), here, (there - here) / (step * norm(d))};
}

bool are_same(const Bend& a, const Bend& b, double length) {
  const double curvature = 1 / length + norm(a.curvature) + norm(b.curvature);
  const double slope = curvature / length + curvature * curvature + norm(a.slope) + norm(b.slope);
  return norm(a.tangent - b.tangent) < same_direction && norm(a.curvature - b.curvature) < same_direction * curvature &&
         norm(a.slope - b.slope) < same_slope * slope;
}

struct Knot {
  double t = 0;
  int multiplicity = 0;
};

std::vector<Knot> knots_of_curve(const SpaceCurve& curve) {
  std::vector<Knot> knots;
  for (const double t : curve.knots) {
    if (knots.empty() || t > knots.back().t) knots.push_back({t, 0});
    ++knots.back().multiplicity;
  }
  return knots;
}

/// Whether derivatives by the parameter jump at a knot, and none by the arc length does.
bool has_rough_parameters(const SpaceCurve& curve, double length) {
  const std::vector<Knot> knots = knots_of_curve(curve);
  bool is_rough = false;
  for (std::size_t i = 1; i + 1 < knots.size(); ++i) {
    if (curve.degree - knots[i].multiplicity >= smooth_derivatives) continue;
    is_rough = true;
    const double t = knots[i].t;
    if (!are_same(bend_at(curve, t, true, t - knots[i - 1].t), bend_at(curve, t, false, knots[i + 1].t - t), length))
      return false;
  }
  return is_rough;
}

std::vector<curve::SpaceFitPoint> points_in_spans(const SpaceLength& length, const std::vector<curve::FitKnot>& knots) {
  std::vector<curve::SpaceFitPoint> points;
  const auto add = [&](double s) { points.push_back({s, surface::point(length.curve(), length.parameter(s))}); };
  add(0);
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double a = knots[k - 1].parameter, b = knots[k].parameter;
    for (int i = 1; i < samples_per_fit_span; ++i) add(a + (b - a) * i / samples_per_fit_span);
    add(b);
  }
  return points;
}

std::optional<SpaceCurve> fitted(const SpaceLength& length, bool is_closed, const std::vector<curve::FitKnot>& knots) {
  const SpaceCurve& curve = length.curve();
  std::optional<curve::SpaceFitEnds> ends;
  if (!is_closed)
    ends = {normalized(surface::derivatives(curve, curve.begin())[1]),
            normalized(surface::derivatives(curve, curve.end(), true)[1])};
  return curve::least_squares_spline(degree, knots, points_in_spans(length, knots), ends);
}

/// The greatest distance of the spline from the curve in each span.
std::vector<double> distances_in_spans(const SpaceLength& length, const SpaceCurve& spline,
                                       const std::vector<curve::FitKnot>& knots) {
  constexpr int places_per_span = 7;  // between the samples
  std::vector<double> distances;
  for (std::size_t k = 1; k < knots.size(); ++k) {
    const double a = knots[k - 1].parameter, b = knots[k].parameter;
    distances.push_back(0);
    for (int i = 0; i < places_per_span; ++i) {
      const double s = a + (b - a) * (i + 0.5) / places_per_span;
      distances.back() = std::max(
          distances.back(), distance(surface::point(spline, s), surface::point(length.curve(), length.parameter(s))));
    }
  }
  return distances;
}

std::vector<curve::FitKnot> with_halved_spans(const std::vector<curve::FitKnot>& knots,
                                              const std::vector<double>& distances, double tolerance) {
  std::vector<curve::FitKnot> finer{knots.front()};
  for (std::size_t k = 1; k < knots.size(); ++k) {
    if (distances[k - 1] >= tolerance) finer.push_back({(knots[k - 1].parameter + knots[k].parameter) / 2, 1});
    finer.push_back(knots[k]);
  }
  return finer;
}

// Spans are halved where the spline is farther off than it will be in halves of the worst one, as curves bend more in
// some places; once that hardly helps, what is left is round-off.
std::optional<SpaceCurve> by_arc_length(const SpaceLength& length) {
  constexpr double least_reduction = 0.25, of_halves = 1.0 / (1 << (degree + 1));
  const bool is_closed = has_smooth_seam(length.curve());
  const double tolerance = fit_tolerance * length.total();
  std::vector<curve::FitKnot> knots;
  for (int i = 0; i <= fewest_spans; ++i) knots.push_back({length.total() * i / fewest_spans, 1});
  std::optional<SpaceCurve> best;
  double least = worst_fit * length.total();
  for (int round = 0; round < most_fits && knots.size() <= most_spans + 1; ++round) {
    std::optional<SpaceCurve> spline = fitted(length, is_closed, knots);
    if (!spline) break;
    const std::vector<double> distances = distances_in_spans(length, *spline, knots);
    const double off = *std::max_element(distances.begin(), distances.end());
    if (best && off > least_reduction * least) break;
    if (off < least) least = off, best = std::move(spline);
    if (off < tolerance) break;
    knots = with_halved_spans(knots, distances, std::max(tolerance, of_halves * off));
  }
  return best;
}

/// None if the parameters are smooth.
std::optional<SpaceCurve> smooth_spline(const SpaceCurve& curve, const SpaceLength& length) {
  if (!has_rough_parameters(curve, length.total())) return std::nullopt;
  std::optional<SpaceCurve> spline = by_arc_length(length);
  // The ends are those of its neighbours in the loop, bit for bit.
  if (spline && spline->poles.front() != spline->poles.back())
    spline->poles.front() = curve.poles.front(), spline->poles.back() = curve.poles.back();
  return spline;
}

}  // namespace

bool has_smooth_seam(const SpaceCurve& curve) {
  constexpr double same_point = 1e-9;
  const double length = SpaceLength(curve).total();
  if (distance(curve.poles.front(), curve.poles.back()) > same_point * length) return false;
  const std::vector<Knot> knots = knots_of_curve(curve);
  return are_same(bend_at(curve, curve.end(), true, knots.back().t - knots[knots.size() - 2].t),
                  bend_at(curve, curve.begin(), false, knots[1].t - knots[0].t), length);
}

SpaceCurve with_smooth_parameters(const SpaceCurve& curve) {
  return smooth_spline(curve, SpaceLength(curve)).value_or(curve);
}

SpaceFace with_smooth_parameters(SpaceFace face) {
  for (std::size_t c = 0; c < face.curves.size(); ++c) {
    const SpaceLength length(face.curves[c]);
    std::optional<SpaceCurve> spline = smooth_spline(face.curves[c], length);
    if (!spline) continue;
    for (FineBoundaryEdge& edge : face.boundary_edges)
      if (edge.curve == static_cast<int>(c)) edge.t0 = length.at(edge.t0), edge.t1 = length.at(edge.t1);
    face.curves[c] = *std::move(spline);
  }
  return face;
}

}  // namespace quadrille::chart
