#include "refine/size_energy.hpp"

#include <algorithm>
#include <cmath>

#include "base/tolerance.hpp"
#include "refine/point_energy.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr double first_shape_weight = 2;  ///< w
constexpr double sharp_sine = 0.5;        ///< of the angle of a corner between curves
}  // namespace

SizeEnergy::SizeEnergy(const RelaxProblem& problem, const QuadMesh& shaped)
    : problem_(problem), loops_(shaped), start_(problem.num_vertices()), inverse_size_(shaped.num_elems(), {1, 1}) {
  const spectral::Quadrature rule = spectral::gauss_lobatto(points);
  const Eigen::MatrixXd slopes = spectral::differentiation_matrix(rule.points);
  curved_rule_.count = points;
  for (int i = 0; i < points; ++i) {
    curved_rule_.at[i] = (1 + rule.points[i]) / 2;
    curved_rule_.weight[i] = rule.weights[i] / 2;
    for (int j = 0; j < points; ++j) slope_[i][j] = 2 * slopes(i, j);
  }
  shape_weights.assign(shaped.num_elems(), first_shape_weight);
  multiplicities.assign(shaped.num_elems(), 1);
  for (int elem = 0; elem < shaped.num_elems(); ++elem) {
    const auto& vertices = problem.follow.elem_vertices()[elem];
    for (int c = 0; c < 4; ++c) start_[vertices[c]] = shaped.nodes[side_start(shaped, elem, c)];
    is_free_.push_back(!std::ranges::all_of(vertices, [&](int v) { return problem.is_fixed[v]; }));
  }
  position_ = start_;
  tangent_.resize(start_.size());
  bend_.resize(start_.size());
  lighten_sharp_corners();
  add_curved_sides(shaped);
}

/// The shape of an element in a sharp corner between two curves, which no motion of vertices changes, does not outweigh
/// that of all others: it gets the weight that the corner would have at 30 degrees.
void SizeEnergy::lighten_sharp_corners() {
  std::vector<std::array<bool, 4>> is_on_curve(shape_weights.size());
  for (const SlidingEdge& edge : problem_.boundary.edges()) is_on_curve[edge.elem][edge.side] = true;
  for (std::size_t elem = 0; elem < is_on_curve.size(); ++elem)
    for (int c = 0; c < 4; ++c) {
      const int before = (c + 3) % 4;
      if (!is_on_curve[elem][c] || !is_on_curve[elem][before]) continue;
      const auto& v = problem_.follow.elem_vertices()[elem];
      const Vec2 out = start_[v[(c + 1) % 4]] - start_[v[c]], in = start_[v[before]] - start_[v[c]];
      const double sine = cross(out, in) / (norm(out) * norm(in));
      if (sine > 0 && sine < sharp_sine && dot(out, in) > 0) shape_weights[elem] *= std::pow(sine / sharp_sine, 3);
    }
}

void SizeEnergy::add_curved_sides(const QuadMesh& shaped) {
  elem_sides_.assign(shaped.num_elems(), -1);
  const std::vector<double>& xi = spectral::gll_points(shaped.order);
  std::vector<double> sampled;
  for (const double t : curved_rule_.at) sampled.push_back(2 * t - 1);
  const Eigen::MatrixXd interpolate = spectral::interpolation_matrix(xi, sampled);
  const auto add = [&](int elem, int side, const CurvedSide& curved) {
    if (elem_sides_[elem] < 0) elem_sides_[elem] = static_cast<int>(curved_.size()), curved_.emplace_back();
    curved_[elem_sides_[elem]].side[side] = static_cast<int>(sides_.size());
    sides_.push_back(curved);
  };
  std::vector<std::array<int, 4>> sliding(shaped.num_elems(), {-1, -1, -1, -1});
  const std::vector<SlidingEdge>& edges = problem_.boundary.edges();
  for (std::size_t e = 0; e < edges.size(); ++e)
    if (!problem_.is_fixed[problem_.follow.vertex_of(edges[e].from)] ||
        !problem_.is_fixed[problem_.follow.vertex_of(edges[e].to)])
      sliding[edges[e].elem][edges[e].side] = static_cast<int>(e);
  for (int elem = 0; shaped.order > 1 && elem < shaped.num_elems(); ++elem) {
    if (!is_free_[elem]) continue;
    for (int side = 0; side < 4; ++side) {
      CurvedSide curved{.edge = sliding[elem][side]};
      const Vec2 from = shaped.nodes[side_node(shaped, elem, side, 0)];
      const Vec2 to = shaped.nodes[side_node(shaped, elem, side, shaped.order)];
      double bend = 0;
      for (int p = 0; p < points; ++p) {
        Vec2 x;
        for (int k = 0; k <= shaped.order; ++k) x += interpolate(p, k) * shaped.nodes[side_node(shaped, elem, side, k)];
        curved.shift[p] = x - ((1 - curved_rule_.at[p]) * from + curved_rule_.at[p] * to);
        bend = std::max(bend, norm(curved.shift[p]));
      }
      if (curved.edge >= 0 || bend > tolerance::tied * distance(from, to)) add(elem, side, curved);
    }
    if (elem_sides_[elem] < 0) continue;
    Sides& sides = curved_[elem_sides_[elem]];
    for (int k = 0; k < 2; ++k) sides.is_linear[k] = sides.side[k] >= 0 && sides.side[k + 2] >= 0;
  }
}

void SizeEnergy::place(const VertexMoves& moves) {
  for (int v = 0; v < problem_.num_vertices(); ++v) {
    if (problem_.is_fixed[v] && moves[v] == Vec2{}) {
      position_[v] = start_[v];
      continue;
    }
    const int b = problem_.follow.on_boundary(v);
    if (b < 0) {
      position_[v] = start_[v] + moves[v];
      continue;
    }
    const SlidingVertex& on_curve = problem_.boundary.vertices()[b];
    const LoopPoint at = loops_.at(on_curve.loop, on_curve.length + moves[v].x);
    position_[v] = at.position;
    tangent_[v] = at.tangent;
    bend_[v] = at.bend;
  }
  for (CurvedSide& side : sides_)
    if (side.edge >= 0) place_side(side, moves);
}

void SizeEnergy::place_side(CurvedSide& side, const VertexMoves& moves) const {
  const SlidingEdge& edge = problem_.boundary.edges()[side.edge];
  const NodeFollow& follow = problem_.follow;
  const int from = follow.vertex_of(edge.from), to = follow.vertex_of(edge.to);
  side.tangent[0] = follow.direction(edge.from) * tangent_[from];
  side.tangent[points - 1] = follow.direction(edge.to) * tangent_[to];
  const SlidingVertex &start = problem_.boundary.vertices()[edge.from], &end = problem_.boundary.vertices()[edge.to];
  const double low = start.length + follow.slide(edge.from, moves);
  const double beyond = end.length <= start.length ? loops_.length(end.loop) : 0;
  const double length = end.length + beyond + follow.slide(edge.to, moves) - low;
  for (int p = 1; p < points - 1; ++p) {
    const LoopPoint at = loops_.at(start.loop, low + curved_rule_.at[p] * length);
    side.tangent[p] = at.tangent;
    side.bend[p] = at.bend;
    side.shift[p] = at.position - ((1 - curved_rule_.at[p]) * position_[from] + curved_rule_.at[p] * position_[to]);
  }
}

double SizeEnergy::blend(const Sides& sides, int side, double eta) const {
  return sides.is_linear[side % 2] ? 1 - eta : (1 - eta) * (1 - eta);
}

double SizeEnergy::blend_slope(const Sides& sides, int side, double eta) const {
  return sides.is_linear[side % 2] ? -1 : -2 * (1 - eta);
}

SizeEnergy::Tangents SizeEnergy::tangents(int elem) const {
  const auto& v = problem_.follow.elem_vertices()[elem];
  const Vec2 c0 = position_[v[0]], c1 = position_[v[1]], c2 = position_[v[2]], c3 = position_[v[3]];
  const Vec2 scale = inverse_size_[elem];
  const Rule& points_at = rule(elem);
  const int n = points_at.count;
  Tangents at;
  for (int j = 0; j < n; ++j)
    for (int i = 0; i < n; ++i) {
      const double s = points_at.at[i], t = points_at.at[j];
      at.a[j * n + i] = scale.x * ((1 - t) * (c1 - c0) + t * (c2 - c3));
      at.b[j * n + i] = scale.y * ((1 - s) * (c3 - c0) + s * (c2 - c1));
    }
  if (elem_sides_[elem] < 0) return at;
  const Sides& sides = curved_[elem_sides_[elem]];
  for (int k = 0; k < 4; ++k) {
    if (sides.side[k] < 0) continue;
    const SidePoints& shift = sides_[sides.side[k]].shift;
    for (int p = 0; p < points; ++p) {
      Vec2 slope;
      for (int q = 0; q < points; ++q) slope += slope_[p][q] * shift[q];
      for (int r = 0; r < points; ++r) {
        const SidePoint x = side_point(k, p, r, points);
        (x.is_along_a ? at.a : at.b)[x.point] +=
            (x.is_along_a ? scale.x : scale.y) * x.along * blend(sides, k, curved_rule_.at[r]) * slope;
        (x.is_along_a ? at.b : at.a)[x.point] +=
            (x.is_along_a ? scale.y : scale.x) * x.across * blend_slope(sides, k, curved_rule_.at[r]) * shift[p];
      }
    }
  }
  return at;
}

void SizeEnergy::set_sizes(const std::vector<Vec2>& sizes) {
  double squares = 0, count = 0;
  inverse_size_.assign(sizes.size(), {1, 1});
  for (int elem = 0; elem < static_cast<int>(sizes.size()); ++elem) {
    if (!is_free_[elem]) continue;
    const Tangents at = tangents(elem);
    double area = 0;
    for (int k = 0; k < rule(elem).size(); ++k) area += rule(elem).weight_at(k) * cross(at.a[k], at.b[k]);
    squares += multiplicities[elem] * area / (sizes[elem].x * sizes[elem].y);
    count += multiplicities[elem];
  }
  const double factor = std::sqrt(count / squares);
  for (std::size_t elem = 0; elem < sizes.size(); ++elem)
    inverse_size_[elem] = {factor / sizes[elem].x, factor / sizes[elem].y};
}

void SizeEnergy::add_element(int elem, EnergyDerivatives& sum) {
  const Tangents at = tangents(elem);
  const auto& v = problem_.follow.elem_vertices()[elem];
  const Rule& points_at = rule(elem);
  Tangents by;
  for (int k = 0; k < points_at.size(); ++k) {
    const double weight = weight_at(elem, k);
    const PointEnergy e(at.a[k], at.b[k], shape_weights[elem]);
    sum.value += weight * e.value;
    by.a[k] = weight * inverse_size_[elem].x * e.by_a;
    by.b[k] = weight * inverse_size_[elem].y * e.by_b;
    const std::array<Vec2, 4> slopes = corner_slopes(points_at.s(k), points_at.t(k));
    for (int c = 0; c < 4; ++c) sum.gradient[v[c]] += slopes[c].x * by.a[k] + slopes[c].y * by.b[k];
    if (!sum.blocks.empty()) add_blocks(elem, at, k, e, sum);
  }
  if (elem_sides_[elem] >= 0) pull_back_sides(elem, by);
}

void SizeEnergy::add_blocks(int elem, const Tangents& at, int point, const PointEnergy& e,
                            EnergyDerivatives& sum) const {
  const double weight = weight_at(elem, point);
  const std::array<Vec2, 4> slopes = corner_slopes(rule(elem).s(point), rule(elem).t(point));
  const Vec2 a = at.a[point], b = at.b[point];
  for (int c = 0; c < 4; ++c) {
    const double e1 = inverse_size_[elem].x * slopes[c].x, e2 = inverse_size_[elem].y * slopes[c].y;
    const Vec2 g = e1 * e.mu_a + e2 * e.mu_b;
    const double round = e.mu_slope * (e1 * e1 + e2 * e2) + e.size_a * e1 * e1 + e.size_b * e2 * e2;
    const double turn_a = e.turn_a * e1 * e1, turn_b = e.turn_b * e2 * e2;
    std::array<double, 3>& h = sum.blocks[problem_.follow.elem_vertices()[elem][c]];
    h[0] += weight * (round + e.mu_bend * g.x * g.x + turn_a * a.x * a.x + turn_b * b.x * b.x);
    h[1] += weight * (e.mu_bend * g.x * g.y + turn_a * a.x * a.y + turn_b * b.x * b.y);
    h[2] += weight * (round + e.mu_bend * g.y * g.y + turn_a * a.y * a.y + turn_b * b.y * b.y);
  }
}

/// The derivatives by the shifts of the points of a side.
SizeEnergy::SidePoints SizeEnergy::by_shifts(const Sides& sides, int side, const Tangents& by) const {
  SidePoints by_shift{};
  for (int p = 0; p < points; ++p)
    for (int r = 0; r < points; ++r) {
      const SidePoint x = side_point(side, p, r, points);
      const Vec2 along = x.along * blend(sides, side, curved_rule_.at[r]) * (x.is_along_a ? by.a : by.b)[x.point];
      by_shift[p] += x.across * blend_slope(sides, side, curved_rule_.at[r]) * (x.is_along_a ? by.b : by.a)[x.point];
      for (int q = 0; q < points; ++q) by_shift[q] += slope_[p][q] * along;
    }
  return by_shift;
}

/// Adds the derivatives by the slides of the ends of curved sides, whose points slide with them.
void SizeEnergy::pull_back_sides(int elem, const Tangents& by) {
  const Sides& sides = curved_[elem_sides_[elem]];
  for (int k = 0; k < 4; ++k) {
    if (sides.side[k] < 0 || sides_[sides.side[k]].edge < 0) continue;
    const CurvedSide& side = sides_[sides.side[k]];
    const SidePoints by_shift = by_shifts(sides, k, by);
    const SlidingEdge& edge = problem_.boundary.edges()[side.edge];
    double from = 0, to = 0;
    for (int p = 1; p < points - 1; ++p) {
      from += (1 - curved_rule_.at[p]) * dot(by_shift[p], side.tangent[p] - side.tangent[0]);
      to += curved_rule_.at[p] * dot(by_shift[p], side.tangent[p] - side.tangent[points - 1]);
    }
    slide_gradient_[problem_.follow.vertex_of(edge.from)] += problem_.follow.direction(edge.from) * from;
    slide_gradient_[problem_.follow.vertex_of(edge.to)] += problem_.follow.direction(edge.to) * to;
  }
}

void SizeEnergy::reduce_to_curves(EnergyDerivatives& sum) const {
  for (int v = 0; v < problem_.num_vertices(); ++v) {
    if (problem_.is_fixed[v]) {
      sum.gradient[v] = {};
    } else if (problem_.follow.on_boundary(v) >= 0) {
      const Vec2 t = tangent_[v];
      if (!sum.blocks.empty()) {
        std::array<double, 3>& h = sum.blocks[v];
        h = {h[0] * t.x * t.x + 2 * h[1] * t.x * t.y + h[2] * t.y * t.y, 0, 1};
      }
      sum.gradient[v] = {dot(sum.gradient[v], t) + slide_gradient_[v], 0};
    }
  }
}

EnergyDerivatives SizeEnergy::with_derivatives(const VertexMoves& moves, bool has_blocks) {
  place(moves);
  const std::size_t count = start_.size();
  EnergyDerivatives sum{0, VertexMoves(count), std::vector<std::array<double, 3>>(has_blocks ? count : 0)};
  slide_gradient_.assign(count, 0);
  for (int elem = 0; elem < static_cast<int>(is_free_.size()) && std::isfinite(sum.value); ++elem)
    if (is_free_[elem]) add_element(elem, sum);
  reduce_to_curves(sum);
  return sum;
}

std::vector<Vec2> SizeEnergy::middles(const VertexMoves& moves) {
  place(moves);
  std::vector<Vec2> middles;
  for (const auto& v : problem_.follow.elem_vertices())
    middles.push_back((position_[v[0]] + position_[v[1]] + position_[v[2]] + position_[v[3]]) / 4);
  return middles;
}

}  // namespace quadrille::refine
