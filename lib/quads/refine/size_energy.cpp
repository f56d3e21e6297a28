#include "refine/size_energy.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

#include "base/tolerance.hpp"
#include "refine/point_energy.hpp"
#include "refine/skew_energy.hpp"
#include "spectral/lagrange.hpp"
#include "spectral/quadrature.hpp"

namespace quadrille::refine {
namespace {

constexpr double first_shape_weight = 1;  ///< w
constexpr double sharp_sine = 0.5;        ///< of the angle of a corner between curves
constexpr double infinity = std::numeric_limits<double>::infinity();

}  // namespace

SizeEnergy::Rule::Rule(int count) : size(count * count) {
  const spectral::Quadrature line = spectral::gauss_lobatto(count);
  for (int k = 0; k < size; ++k) {
    s[k] = (1 + line.points[k % count]) / 2;
    t[k] = (1 + line.points[k / count]) / 2;
    weight[k] = line.weights[k % count] * line.weights[k / count] / 4;
  }
}

SizeEnergy::SizeEnergy(const RelaxProblem& problem, const QuadMesh& shaped)
    : problem_(problem), loops_(shaped), start_(problem.num_vertices()), inverse_size_(shaped.num_elems(), {1, 1}) {
  const Eigen::MatrixXd slopes = spectral::differentiation_matrix(spectral::gauss_lobatto(points).points);
  for (int i = 0; i < points; ++i) {
    const double eta = along_[i] = curved_rule_.s[i];
    for (int j = 0; j < points; ++j) slope_[i][j] = 2 * slopes(i, j);
    linear_.value[i] = 1 - eta, linear_.slope[i] = -1;
    quadratic_.value[i] = (1 - eta) * (1 - eta), quadratic_.slope[i] = -2 * (1 - eta);
  }
  shape_weights.assign(shaped.num_elems(), first_shape_weight);
  skew_weights = shape_weights;
  multiplicities.assign(shaped.num_elems(), 1);
  for (int elem = 0; elem < shaped.num_elems(); ++elem) {
    const auto& vertices = problem.follow.elem_vertices()[elem];
    for (int c = 0; c < 4; ++c) start_[vertices[c]] = shaped.nodes[side_start(shaped, elem, c)];
    is_free_.push_back(!std::ranges::all_of(vertices, [&](int v) { return problem.is_fixed[v]; }));
  }
  position_ = start_;
  tangent_.resize(start_.size()), bend_.resize(start_.size());
  lighten_sharp_corners();
  weigh_angles(shaped);
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

/// The energy of thin elements is greater, by mu of a rectangle of their sides at least. Angles of a block that was
/// made skew, as in a sharp corner, are held at most to what they were.
void SizeEnergy::weigh_angles(const QuadMesh& shaped) {
  std::vector<double> least(shaped.block_names.size(), sharp_sine);
  for (int elem = 0; elem < shaped.num_elems(); ++elem) {
    double& of_block = least[shaped.elem_block[elem]];
    of_block = std::min(of_block, std::max(0.0, shaped.elem_scaled_jacobian[elem]));
  }
  for (int elem = 0; elem < shaped.num_elems(); ++elem) {
    const double ratio = shaped.elem_edge_ratio[elem], mu = (ratio + 1 / ratio) / 2;
    skew_weights[elem] *= mu * std::pow(least[shaped.elem_block[elem]] / sharp_sine, skew_power);
  }
}

void SizeEnergy::add_curved_sides(const QuadMesh& shaped) {
  elem_sides_.assign(shaped.num_elems(), -1);
  const std::vector<double>& xi = spectral::gll_points(shaped.order);
  std::vector<double> sampled;
  for (const double t : along_) sampled.push_back(2 * t - 1);
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
        curved.shift[p] = x - ((1 - along_[p]) * from + along_[p] * to);
        bend = std::max(bend, norm(curved.shift[p]));
      }
      curved.slope = slopes_of(curved.shift);
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
    position_[v] = at.position, tangent_[v] = at.tangent, bend_[v] = at.bend;
  }
  for (CurvedSide& side : sides_)
    if (side.edge >= 0) place_side(side, moves);
  update_sizes();
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
    const LoopPoint at = loops_.at(start.loop, low + along_[p] * length);
    side.tangent[p] = at.tangent;
    side.bend[p] = at.bend;
    side.shift[p] = at.position - ((1 - along_[p]) * position_[from] + along_[p] * position_[to]);
  }
  side.slope = slopes_of(side.shift);
}

SizeEnergy::SidePoints SizeEnergy::slopes_of(const SidePoints& shift) const {
  SidePoints slopes{};
  for (int p = 0; p < points; ++p)
    for (int q = 0; q < points; ++q) slopes[p] += slope_[p][q] * shift[q];
  return slopes;
}

template <class Visit>
void SizeEnergy::with_size(const Rule& rule, const Visit& visit) {
  if (rule.size == 4)
    visit(std::integral_constant<int, 4>{});
  else
    visit(std::integral_constant<int, points * points>{});
}

/// `at`: that of the element, or one with more points for a bilinear one.
SizeEnergy::Tangents SizeEnergy::tangents(int elem, const Rule& at) const {
  const auto& v = problem_.follow.elem_vertices()[elem];
  const Vec2 scale = inverse_size_[elem];
  const Vec2 bottom = scale.x * (position_[v[1]] - position_[v[0]]),
             top = scale.x * (position_[v[2]] - position_[v[3]]);
  const Vec2 left = scale.y * (position_[v[3]] - position_[v[0]]),
             right = scale.y * (position_[v[2]] - position_[v[1]]);
  Tangents tangents;
  with_size(at, [&](auto n) {
    for (int k = 0; k < n; ++k) {
      tangents.a.x[k] = bottom.x + at.t[k] * (top.x - bottom.x);
      tangents.a.y[k] = bottom.y + at.t[k] * (top.y - bottom.y);
      tangents.b.x[k] = left.x + at.s[k] * (right.x - left.x);
      tangents.b.y[k] = left.y + at.s[k] * (right.y - left.y);
    }
  });
  if (elem_sides_[elem] >= 0) add_shifts(elem, tangents);
  stretch(elem, at, tangents);
  return tangents;
}

/// Of the points of curved sides from their chords, blended into the element.
void SizeEnergy::add_shifts(int elem, Tangents& at) const {
  const Sides& sides = curved_[elem_sides_[elem]];
  for (int side = 0; side < 4; ++side) {
    if (sides.side[side] < 0) continue;
    const CurvedSide& curved = sides_[sides.side[side]];
    const Blend& blended = blend(sides, side);
    with_side(side, [&](auto known) {
      constexpr SideFrame frame = side_frame(known, points);
      constexpr bool is_along_a = known % 2 == 0;
      const double along = frame.along * (is_along_a ? inverse_size_[elem].x : inverse_size_[elem].y);
      const double across = frame.across * (is_along_a ? inverse_size_[elem].y : inverse_size_[elem].x);
      for (int r = 0; r < points; ++r)
        for (int p = 0; p < points; ++p) {
          (is_along_a ? at.a : at.b).add(frame.point(p, r), along * blended.value[r] * curved.slope[p]);
          (is_along_a ? at.b : at.a).add(frame.point(p, r), across * blended.slope[r] * curved.shift[p]);
        }
    });
  }
}

/// The energy of an element, and its derivatives by x_s and x_t at the points of its rule.
double SizeEnergy::slopes(int elem, const Tangents& at, Tangents& by) const {
  const Rule& of = rule(elem);
  const Vec2 scale = inverse_size_[elem];
  const double shape = shape_weights[elem], multiplicity = multiplicities[elem];
  const double skew = stretches.empty() ? skew_weights[elem] : 0;
  std::array<double, points * points> det, value;
  double sum = 0;
  with_size(of, [&](auto n) {
    for (int k = 0; k < n; ++k) {
      PointEnergy e(at.a[k], at.b[k], shape);
      add_skewness(at.a[k], at.b[k], skew, e);
      const double weight = multiplicity * of.weight[k], by_s = scale.x * weight, by_t = scale.y * weight;
      det[k] = e.det, value[k] = weight * e.value;
      by.a.x[k] = by_s * e.by_a.x, by.a.y[k] = by_s * e.by_a.y;
      by.b.x[k] = by_t * e.by_b.x, by.b.y[k] = by_t * e.by_b.y;
    }
    for (int k = 0; k < n; ++k) sum += det[k] > 0 ? value[k] : infinity;
  });
  if (direction(elem) != Vec2{}) sum += add_direction(elem, at, by);
  if (stretches.empty()) return sum;
  stretch(elem, of, by);
  return sum + add_skewness_in_plane(elem, at, by);
}

void SizeEnergy::add_element(int elem, EnergyDerivatives& sum) {
  const Tangents at = tangents(elem);
  Tangents by;
  sum.value += slopes(elem, at, by);
  const std::array<Vec2, 4> by_corner = by_corners(elem, by);
  const Vec2 by_growth = by_middle(elem, at, by) / 4;
  const auto& v = problem_.follow.elem_vertices()[elem];
  for (int c = 0; c < 4; ++c) sum.gradient[v[c]] += by_corner[c] + by_growth;
  if (!sum.blocks.empty()) add_blocks(elem, at, sum);
  if (elem_sides_[elem] >= 0) pull_back_sides(elem, by);
}

/// The derivatives by the corners, from those by x_s and x_t.
std::array<Vec2, 4> SizeEnergy::by_corners(int elem, const Tangents& by) const {
  const Rule& of = rule(elem);
  Vec2 by_a, high_a, by_b, high_b;
  with_size(of, [&](auto n) {
    for (int k = 0; k < n; ++k) {
      by_a += by.a[k], high_a += of.t[k] * by.a[k];
      by_b += by.b[k], high_b += of.s[k] * by.b[k];
    }
  });
  const Vec2 bottom = by_a - high_a, top = high_a, left = by_b - high_b, right = high_b;
  return {-(bottom + left), bottom - right, top + right, left - top};
}

/// The derivatives by the shifts of the points of a side.
SizeEnergy::SidePoints SizeEnergy::by_shifts(const Sides& sides, int side, const Tangents& by) const {
  const Blend& blended = blend(sides, side);
  SidePoints by_shift{};
  with_side(side, [&](auto known) {
    constexpr SideFrame frame = side_frame(known, points);
    const Vectors &by_along = known % 2 == 0 ? by.a : by.b, &by_across = known % 2 == 0 ? by.b : by.a;
    for (int p = 0; p < points; ++p) {
      Vec2 by_slope;
      for (int r = 0; r < points; ++r) {
        by_slope += frame.along * blended.value[r] * by_along[frame.point(p, r)];
        by_shift[p] += frame.across * blended.slope[r] * by_across[frame.point(p, r)];
      }
      for (int q = 0; q < points; ++q) by_shift[q] += slope_[p][q] * by_slope;
    }
  });
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
      from += (1 - along_[p]) * dot(by_shift[p], side.tangent[p] - side.tangent[0]);
      to += along_[p] * dot(by_shift[p], side.tangent[p] - side.tangent[points - 1]);
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

}  // namespace quadrille::refine
