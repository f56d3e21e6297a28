#include "field/error_estimate.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numeric>
#include <optional>

#include "base/angle.hpp"
#include "curve/chain.hpp"
#include "curve/nurbs.hpp"
#include "field/boundary_values.hpp"
#include "field/explicit_value.hpp"
#include "field/phase_boundary.hpp"
#include "mesh/tri_topology.hpp"
#include "spectral/orthogonal_basis.hpp"

namespace quadrille::field {
namespace {

constexpr std::array fractions{0.1, 0.37, 0.63, 0.9};

struct EdgePoint {
  double t;
  Vec2 xi;
  double phase_data;  ///< of a phase: its boundary data without the hole winding
};

/// `phase`: null for a harmonic field.
std::array<EdgePoint, fractions.size()> edge_points(const BoundaryEdge& edge, const curve::ArcLength& length,
                                                    const PhaseBoundary* phase) {
  const double begin = length.at(edge.t0), whole = length.at(edge.t1) - begin;
  std::array<double, fractions.size()> t{}, data{};
  for (std::size_t i = 0; i < t.size(); ++i) t[i] = length.parameter(begin + fractions[i] * whole);
  if (phase) phase->remainders(edge.curve, t, data.data());
  std::array<EdgePoint, fractions.size()> points;
  for (std::size_t i = 0; i < t.size(); ++i)
    points[i] = {t[i], spectral::tri_edge_point(edge.edge, fractions[i]), data[i]};
  return points;
}

/// How far a field differs from its boundary data, and its slope across the boundary.
struct Misfit {
  double difference, slope;
  Vec2 x;  ///< the point of the element
};

Misfit misfit_at(const Field& field, const BoundaryValues& values, const spectral::TriMap& map,
                 const BoundaryEdge& edge, const EdgePoint& at, Vec2 across) {
  const int offset = field.coef_offsets[edge.elem];
  Vec2 x_h;
  Mat2 dx_dxi, dv_dxi;
  map.evaluate(at.xi, x_h, dx_dxi);
  const Vec2 value =
      spectral::orthogonal_sum(field.elem_order[edge.elem], &field.u[offset], &field.v[offset], at.xi, dv_dxi);
  Vec2 slope = (dv_dxi * inverse(dx_dxi)) * across;
  for (const Lifting& lifting : field.liftings) slope += lifting.jump * dot(lifting_gradient(lifting, x_h), across);
  return {distance(value, values(edge.curve, at.t)), norm(slope), x_h};
}

// |phi_h - Phi| of a phase, radians; equal to |v - v_h| to first order, because v is a unit vector.
Misfit phase_misfit_at(const Field& field, const spectral::TriMap& map, const BoundaryEdge& edge, const EdgePoint& at,
                       Vec2 across) {
  const RemainderSample s =
      remainder_sample(map, field.elem_order[edge.elem], &field.phase.s[field.coef_offsets[edge.elem]], at.xi);
  const int loop = field.mesh.face.loop_of(edge.curve);
  const double data = at.phase_data + (loop > 0 ? 2 * pi * field.phase.hole_winding[loop - 1] : 0);
  const Vec2 slope = s.slope + explicit_phase_gradient(field.phase.terms, s.x);
  return {std::abs(s.value - data), dot(slope, across), s.x};
}

struct EstimateConstants {
  double rounding = 1e-15;      // of values of size 1
  double slowest_decay = 0.95;  // of the modes by degree
  // A misfit is the maximum of values that change sign along an edge, whereas a tail is a mean: less of a misfit
  // affects other elements.
  double sent_of_misfit = 0.1;
  double share_from_afar = 0.1;
  double capacity = 0.73;  // of an equilateral triangle of circumradius 1
};
constexpr EstimateConstants estimate_constants;

// The local error of an element and the quantities that determine its effect on other elements.
struct Source {
  double tail = 0;        // tau
  double unresolved = 0;  // tau / sigma
  Vec2 centre;
  double radius = 0;
  int order = 1;
};

// Norms of the modes by degree: of both components of v, or of s for a phase.
std::vector<double> norms_by_degree(const Field& field, int elem) {
  std::vector<double> norms(field.elem_order[elem] + 1, 0.0);
  for (const auto* component : {&field.u, &field.v, &field.phase.s})
    if (!component->empty()) add_squared_norms(&(*component)[field.coef_offsets[elem]], norms);
  for (double& norm : norms) norm = std::sqrt(norm);
  return norms;
}

// The tail extrapolated by one degree. The mean (degree 0) does not enter the convergence rate; order 2 has one norm
// for each of the two maxima, and order 1 has no rate.
double extrapolated_tail(const std::vector<double>& norms) {
  const double slowest = estimate_constants.slowest_decay;
  const int order = static_cast<int>(norms.size()) - 1;
  if (order == 1) return slowest * norms[1];
  const int width = order == 2 ? 1 : 2;  // number of degrees per maximum
  const double last = std::max(norms[order], norms[order - width + 1]);
  const double before = std::max(norms[order - width], norms[std::max(order - 2 * width + 1, 1)]);
  const double rate = before > 0 ? std::min(std::pow(last / before, 1.0 / width), slowest) : slowest;
  return rate * last;
}

Source source(const Field& field, int elem, double misfit) {
  const std::vector<double> norms = norms_by_degree(field, elem);
  const auto& [a, b, c] = field.mesh.elem2vertices[elem];
  const std::vector<Vec2>& x = field.mesh.vertices;
  Source s;
  s.order = field.elem_order[elem];
  s.tail = std::max(extrapolated_tail(norms), estimate_constants.sent_of_misfit * misfit);
  const double variation = std::sqrt(std::inner_product(norms.begin() + 1, norms.end(), norms.begin() + 1, 0.0));
  s.unresolved = variation > 0 ? std::min(s.tail / variation, 1.0) : 1;
  s.centre = (x[a] + x[b] + x[c]) / 3;
  s.radius = std::sqrt(std::max({norm2(x[a] - s.centre), norm2(x[b] - s.centre), norm2(x[c] - s.centre)}));
  return s;
}

double integer_power(double base, int exponent) {
  double power = 1;
  for (; exponent > 0; exponent /= 2, base *= base) {
    if (exponent % 2 == 1) power *= base;
  }
  return power;
}

// Fraction of the tail of source s that contributes to the error at a distance from it.
double weight(const Source& s, double distance) {
  const double nearness = s.radius / std::max(distance, s.radius);
  return nearness * std::max(integer_power(estimate_constants.capacity * nearness, s.order + 1), s.unresolved);
}

// Beyond this distance the weight is s.unresolved * s.radius / distance.
double end_of_near_field(const Source& s) {
  return s.radius * std::max(1.0, estimate_constants.capacity * std::pow(s.unresolved, -1.0 / (s.order + 1)));
}

// The sources with the greatest contributions, in descending order; equal ones by element number.
std::vector<int> strongest(const std::vector<Source>& sources) {
  constexpr std::size_t most = 512;
  std::vector<int> ranking(sources.size());
  std::iota(ranking.begin(), ranking.end(), 0);
  const auto sends_more = [&](int a, int b) {
    const double left = sources[a].tail * sources[a].radius, right = sources[b].tail * sources[b].radius;
    return left != right ? left > right : a < b;
  };
  const auto end = ranking.begin() + static_cast<std::ptrdiff_t>(std::min(most, ranking.size()));
  std::partial_sort(ranking.begin(), end, ranking.end(), sends_more);
  ranking.erase(end, ranking.end());
  return ranking;
}

// The sum of the tails of the strongest sources by their weights. Nearly all of them are far, and those are summed by
// vector instructions.
class RemoteErrors {
 public:
  explicit RemoteErrors(const std::vector<Source>& sources) : sources_(sources), senders_(strongest(sources)) {
    const auto n = static_cast<Eigen::Index>(senders_.size());
    x_.resize(n), y_.resize(n), strength_.resize(n), near2_.resize(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Source& s = sources[senders_[i]];
      const double near = end_of_near_field(s);
      x_[i] = s.centre.x, y_[i] = s.centre.y;
      strength_[i] = s.tail * s.unresolved * s.radius;
      near2_[i] = near * near;
    }
  }

  double at(int elem) {
    const Vec2 x = sources_[elem].centre;
    distance2_ = (x_ - x.x).square() + (y_ - x.y).square();
    double sum = (distance2_ > near2_).select(strength_ / distance2_.sqrt(), 0).sum();
    for (Eigen::Index i = 0; i < x_.size(); ++i) {
      if (distance2_[i] > near2_[i] || senders_[i] == elem) continue;
      const Source& s = sources_[senders_[i]];
      sum += s.tail * weight(s, std::sqrt(distance2_[i]));
    }
    return sum;
  }

 private:
  const std::vector<Source>& sources_;
  std::vector<int> senders_;
  Eigen::ArrayXd x_, y_, strength_, near2_;  // of the senders
  Eigen::ArrayXd distance2_;
};

}  // namespace

std::vector<double> boundary_misfit(const Field& field, const PhaseBoundary* phase) {
  const TriMesh& mesh = field.mesh;
  const std::vector<spectral::TriMap> maps = mesh::tri_maps(mesh);
  std::vector<curve::ArcLength> lengths;
  lengths.reserve(mesh.face.curves.size());
  for (const Nurbs& curve : mesh.face.curves) lengths.emplace_back(curve);
  std::optional<PhaseBoundary> made;
  if (field.kind == FieldKind::phase && !phase)
    phase =
        &made.emplace(mesh, field.phase.prescribed, std::make_shared<SharedCorners>(mesh.face, field.phase.prescribed));
  const BoundaryValues values(mesh, field.liftings);
  std::vector<double> misfits(mesh.num_elems(), 0.0);
  for (const BoundaryEdge& edge : mesh.boundary_edges) {
    const spectral::TriMap& map = maps[edge.elem];
    const Nurbs& curve = mesh.face.curves[edge.curve];
    for (const EdgePoint& at : edge_points(edge, lengths[edge.curve], phase)) {
      const Vec2 across = left_of(curve::tangent(curve, at.t));
      const auto [difference, slope, x] =
          phase ? phase_misfit_at(field, map, edge, at, across) : misfit_at(field, values, map, edge, at, across);
      const double misfit = difference + std::abs(slope * dot(x - curve::point(curve, at.t), across));
      misfits[edge.elem] = std::max(misfits[edge.elem], misfit);
    }
  }
  return misfits;
}

void add_squared_norms(const double* coefs, std::vector<double>& norms) {
  for (int degree = 0, i = 0; degree < static_cast<int>(norms.size()); ++degree)
    for (; i < spectral::num_tri_modes(degree); ++i) norms[degree] += coefs[i] * coefs[i];
}

std::vector<double> error_estimate(const Field& field, const PhaseBoundary* phase_boundary, Progress* progress) {
  const int n = field.mesh.num_elems();
  const Progress::Part part(progress, "error estimate", n + std::ssize(field.mesh.boundary_edges));
  const std::vector<double> misfits = boundary_misfit(field, phase_boundary);
  part.advance(std::ssize(field.mesh.boundary_edges));
  std::vector<Source> sources(n);
  for (int e = 0; e < n; ++e) sources[e] = source(field, e, misfits[e]);
  RemoteErrors remote(sources);
  std::vector<double> errors(n);
  for (int e = 0; e < n; ++e, part.advance())
    errors[e] = std::max(sources[e].tail, misfits[e]) + estimate_constants.share_from_afar * remote.at(e) +
                estimate_constants.rounding;
  return errors;
}

double position_error(const Mat2& j, double field_error) {
  const double sum = j.xx * j.xx + j.xy * j.xy + j.yx * j.yx + j.yy * j.yy, d = std::abs(det(j));
  const double greatest = std::sqrt((sum + std::sqrt(std::max(sum * sum - 4 * d * d, 0.0))) / 2);
  return d > 0 ? field_error * greatest / d : std::numeric_limits<double>::infinity();
}

}  // namespace quadrille::field
