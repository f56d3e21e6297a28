#include "triangulate/curved_edges.hpp"

#include <algorithm>
#include <cmath>

#include "base/angle.hpp"
#include "curve/nurbs.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/orthogonal_basis.hpp"
#include "spectral/quadrature.hpp"
#include "spectral/tri_bernstein.hpp"
#include "spectral/tri_map.hpp"

namespace quadrille::triangulate {
namespace {

constexpr double round_off = 1e-15;

/// cos(pi j k / n) for j, k = 0..n, with j k reduced modulo 2 n.
template <int n>
const std::array<double, 2 * n>& cosines() {
  static const auto table = [] {
    std::array<double, 2 * n> values{};
    for (int i = 0; i < 2 * n; ++i) values[i] = std::cos(pi * i / n);
    return values;
  }();
  return table;
}

/// Value and derivative of a Chebyshev series at x in [-1, 1] (Clenshaw).
template <std::size_t n>
std::array<double, 2> evaluate(const std::array<double, n>& c, double x) {
  double b1 = 0, b2 = 0, d1 = 0, d2 = 0;
  for (std::size_t k = n - 1; k > 0; --k) {
    const double d0 = 2 * (b1 + x * d1) - d2;
    const double b0 = c[k] + 2 * x * b1 - b2;
    d2 = d1, d1 = d0, b2 = b1, b1 = b0;
  }
  return {c[0] + x * b1 - b2, b1 + x * d1 - d2};
}

/// Rounding error of the speed between t0 and t1: on a small curve far from the origin, few digits are significant.
double speed_noise(const Nurbs& curve, double t0, double t1) {
  double scale = 0;
  for (const Vec2 pole : curve.poles) scale = std::max({scale, std::abs(pole.x), std::abs(pole.y)});
  const auto above = std::upper_bound(curve.knots.begin(), curve.knots.end() - 1, (t0 + t1) / 2);
  return round_off * scale * curve.degree / (*above - *(above - 1));
}

constexpr int num_turn_samples = 8;

using Vertices = std::array<Vec2, 3>;

std::array<double, 3> barycentric(Vec2 xi) { return {-(xi.x + xi.y) / 2, (1 + xi.x) / 2, (1 + xi.y) / 2}; }

/// For each local edge: displacements of the edge's inner nodes -> displacements of all nodes.
std::array<Eigen::MatrixXd, 3> edge_extensions(int order) {
  const auto& gll = spectral::gll_points(order);
  const std::vector<double> inner(gll.begin() + 1, gll.end() - 1);
  const auto& nodes = spectral::tri_nodes(order);
  std::array<Eigen::MatrixXd, 3> extensions;
  for (int edge = 0; edge < 3; ++edge) {
    std::vector<double> along;
    for (const Vec2 xi : nodes) {
      const auto lambda = barycentric(xi);
      along.push_back(lambda[(edge + 1) % 3] - lambda[edge]);
    }
    Eigen::MatrixXd& extension = extensions[edge] = spectral::interpolation_matrix(inner, along);
    for (std::size_t i = 0; i < nodes.size(); ++i) {
      const auto lambda = barycentric(nodes[i]);
      for (std::size_t j = 0; j < inner.size(); ++j)
        extension(i, j) *= lambda[edge] * lambda[(edge + 1) % 3] * 4 / (1 - inner[j] * inner[j]);
    }
  }
  return extensions;
}

Vertices vertices_of(const TriMesh& mesh, int elem) {
  const auto& [a, b, c] = mesh.elem2vertices[elem];
  return {mesh.vertices[a], mesh.vertices[b], mesh.vertices[c]};
}

std::vector<Vec2> straight_nodes(int order, const Vertices& x) {
  std::vector<Vec2> result;
  for (const Vec2 xi : spectral::tri_nodes(order)) {
    const auto lambda = barycentric(xi);
    result.push_back(x[0] + (lambda[1] * (x[1] - x[0]) + lambda[2] * (x[2] - x[0])));
  }
  for (int k = 0; k < 3; ++k) result[k] = x[k];
  return result;
}

/// Displaces the nodes of an element so that local edge `edge` passes through `on_curve`.
void bend(const Eigen::MatrixXd& extension, const Vertices& x, int order, int edge, const std::vector<Vec2>& on_curve,
          std::vector<Vec2>& nodes) {
  const auto& gll = spectral::gll_points(order);
  const Vec2 from = x[edge], to = x[(edge + 1) % 3];
  std::vector<Vec2> displacements;
  for (int j = 1; j < order; ++j) displacements.push_back((on_curve[j - 1] - from) - (1 + gll[j]) / 2 * (to - from));
  for (std::size_t i = 0; i < nodes.size(); ++i)
    for (std::size_t j = 0; j < displacements.size(); ++j) nodes[i] += extension(i, j) * displacements[j];
}

std::vector<char> straight_curves(const Outline& outline) {
  std::vector<char> result(outline.face().num_curves(), 0);
  for (const SmoothPiece& piece : outline.pieces()) result[piece.curve] = piece.is_straight;
  return result;
}

}  // namespace

ArcLengthTable::ArcLengthTable(const Nurbs& curve, double t0, double t1) {
  double begin = t0;
  const double negligible = 1e-12 * (t1 - t0);
  for (const double knot : curve.knots) {
    if (knot <= begin + negligible || knot >= t1 - negligible) continue;
    add_span(curve, begin, knot, speed_noise(curve, begin, knot), 0);
    begin = knot;
  }
  add_span(curve, begin, t1, speed_noise(curve, begin, t1), 0);
}

void ArcLengthTable::add_span(const Nurbs& curve, double t0, double t1, double noise, int depth) {
  constexpr int n = degree, max_depth = 12;
  const auto& cosine = cosines<n>();
  const double middle = (t0 + t1) / 2, half = (t1 - t0) / 2;
  std::array<double, n + 1> speed{};
  for (int j = 0; j <= n; ++j) speed[j] = norm(curve::derivatives(curve, middle + half * cosine[j], j == 0)[1]);
  // Chebyshev coefficients a of the interpolant of the speed.
  std::array<double, n + 3> a{};
  for (int k = 0; k <= n; ++k) {
    double sum = (speed[0] + speed[n] * (k % 2 == 0 ? 1 : -1)) / 2;
    for (int j = 1; j < n; ++j) sum += speed[j] * cosine[(j * k) % (2 * n)];
    a[k] = sum * 2 / n;
  }
  a[0] /= 2;
  a[n] /= 2;
  const double rest = std::abs(a[n]) + std::abs(a[n - 1]);
  if (depth < max_depth && rest > n * round_off * std::abs(a[0]) + noise) {
    add_span(curve, t0, middle, noise, depth + 1);
    add_span(curve, middle, t1, noise, depth + 1);
    return;
  }
  Span span;
  span.t0 = t0;
  span.t1 = t1;
  span.begin = spans_.empty() ? 0 : spans_.back().end;
  for (int k = 1; k <= n + 1; ++k) span.length[k] = half * ((k == 1 ? 2 : 1) * a[k - 1] - a[k + 1]) / (2 * k);
  for (int k = 1; k <= n + 1; ++k) span.length[0] += (k % 2 == 0 ? -1 : 1) * span.length[k];
  span.end = span.begin + evaluate(span.length, 1)[0];
  spans_.push_back(span);
}

double ArcLengthTable::parameter(double fraction) const {
  const double target = fraction * length();
  const auto found = std::find_if(spans_.begin(), spans_.end(), [&](const Span& span) { return target <= span.end; });
  const Span& span = found == spans_.end() ? spans_.back() : *found;
  const double missing = std::clamp(target - span.begin, 0.0, span.end - span.begin);
  double x = 2 * missing / (span.end - span.begin) - 1;
  for (int iteration = 0; iteration < 30; ++iteration) {
    const auto [s, slope] = evaluate(span.length, x);
    const double step = slope > 0 ? (missing - s) / slope : 0;
    x = std::clamp(x + step, -1.0, 1.0);
    if (std::abs(step) < 1e-9) break;
  }
  return x >= 1 ? span.t1 : x <= -1 ? span.t0 : (span.t0 + span.t1) / 2 + x * (span.t1 - span.t0) / 2;
}

EdgeFit::EdgeFit(const Outline& outline, int order) : outline_(&outline), order_(order) {
  const auto& points = spectral::gll_points(order);
  std::vector<double> samples;
  for (int i = 0; i < order; ++i) samples.push_back((points[i] + points[i + 1]) / 2);
  samples_ = spectral::interpolation_matrix(points, samples);
  for (const double x : points) fractions_.push_back((1 + x) / 2);
  for (const double x : samples) sample_fractions_.push_back((1 + x) / 2);
}

std::vector<Vec2> EdgeFit::inner_nodes(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  return inner_nodes(nurbs, ArcLengthTable(nurbs, t0, t1));
}

std::vector<Vec2> EdgeFit::inner_nodes(const Nurbs& curve, const ArcLengthTable& stretch) const {
  std::vector<Vec2> nodes;
  for (int j = 1; j < order_; ++j) nodes.push_back(curve::point(curve, stretch.parameter(fractions_[j])));
  return nodes;
}

double EdgeFit::error(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  const ArcLengthTable stretch(nurbs, t0, t1);
  std::vector<Vec2> nodes = inner_nodes(nurbs, stretch);
  nodes.insert(nodes.begin(), curve::point(nurbs, t0));
  nodes.push_back(curve::point(nurbs, t1));
  double worst = 0;
  for (int i = 0; i < order_; ++i) {
    // Coordinates relative to the first node: an error of 1e-12 must exceed the rounding errors of the position.
    Vec2 value;
    for (int j = 1; j <= order_; ++j) value += samples_(i, j) * (nodes[j] - nodes[0]);
    const auto d = curve::derivatives(nurbs, stretch.parameter(sample_fractions_[i]));
    const double speed = norm(d[1]);
    const Vec2 miss = value - (d[0] - nodes[0]);
    worst = std::max(worst, speed > 0 ? std::abs(cross(d[1] / speed, miss)) : norm(miss));
  }
  return worst;
}

double EdgeFit::turn(int curve, double t0, double t1) const {
  const Nurbs& nurbs = outline_->face().curves[curve];
  double sum = 0;
  Vec2 before = curve::tangent(nurbs, t0, false);
  // Each knot span is sampled separately.
  const std::vector<double> ends = span_ends(nurbs, t0, t1);
  for (std::size_t i = 0; i + 1 < ends.size(); ++i) {
    for (int k = 1; k <= num_turn_samples; ++k) {
      const double t = ends[i] + (ends[i + 1] - ends[i]) * k / num_turn_samples;
      const Vec2 here = curve::tangent(nurbs, t, k == num_turn_samples);
      sum += std::abs(std::atan2(cross(before, here), dot(before, here)));
      before = here;
    }
  }
  return sum;
}

void curve_elements(const EdgeFit& fit, TriMesh& mesh) {
  mesh.curved_elems.clear();
  mesh.curved_nodes.clear();
  if (mesh.order < 2) return;
  const auto is_straight = straight_curves(fit.outline());
  std::vector<const BoundaryEdge*> edges;
  for (const BoundaryEdge& edge : mesh.boundary_edges)
    if (!is_straight[edge.curve]) edges.push_back(&edge);
  std::stable_sort(edges.begin(), edges.end(), [](auto* a, auto* b) { return a->elem < b->elem; });
  const auto extensions = edge_extensions(mesh.order);
  for (std::size_t i = 0; i < edges.size();) {
    const int elem = edges[i]->elem;
    const Vertices x = vertices_of(mesh, elem);
    std::vector<Vec2> nodes = straight_nodes(mesh.order, x);
    std::vector<std::pair<int, Vec2>> exact;
    for (; i < edges.size() && edges[i]->elem == elem; ++i) {
      const auto on_curve = fit.inner_nodes(edges[i]->curve, edges[i]->t0, edges[i]->t1);
      bend(extensions[edges[i]->edge], x, mesh.order, edges[i]->edge, on_curve, nodes);
      for (int j = 1; j < mesh.order; ++j)
        exact.emplace_back(spectral::tri_edge_node(mesh.order, edges[i]->edge, j), on_curve[j - 1]);
    }
    // Replaces the edge nodes by the exact points of the curve.
    for (const auto& [node, position] : exact) nodes[node] = position;
    mesh.curved_elems.push_back(elem);
    mesh.curved_nodes.insert(mesh.curved_nodes.end(), nodes.begin(), nodes.end());
  }
}

std::vector<double> jacobian_ratio_bounds(const TriMesh& mesh) {
  std::vector<double> ratios(mesh.num_elems(), 1.0);
  const int num_nodes = spectral::num_tri_modes(mesh.order);
  for (int e = 0; e < mesh.num_elems(); ++e) {
    const Vertices x = vertices_of(mesh, e);
    if (cross(x[1] - x[0], x[2] - x[0]) <= 0) ratios[e] = -1;
  }
  std::vector<Vec2> local(num_nodes);
  for (std::size_t c = 0; c < mesh.curved_elems.size(); ++c) {
    const int e = mesh.curved_elems[c];
    const Vertices x = vertices_of(mesh, e);
    // Coordinates relative to a vertex: small elements far from the origin keep their significant digits.
    for (int i = 0; i < num_nodes; ++i) local[i] = mesh.curved_nodes[c * num_nodes + i] - x[0];
    const spectral::TriMap map(mesh.order, local.data());
    const auto bx = spectral::bernstein_from_orthogonal(mesh.order, map.coefs_x());
    const auto by = spectral::bernstein_from_orthogonal(mesh.order, map.coefs_y());
    const double straight = cross(x[1] - x[0], x[2] - x[0]) / 4;
    const double bound = spectral::jacobian_lower_bound(mesh.order, bx, by);
    ratios[e] = straight > 0 ? bound / straight : std::min(bound, 0.0) - 1;
  }
  return ratios;
}

}  // namespace quadrille::triangulate
