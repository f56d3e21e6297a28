#include "zeros/cell.hpp"

#include <algorithm>

#include "spectral/tri_bernstein.hpp"

namespace quadrille::zeros {
namespace {

std::vector<double> of_degree(int degree, int order, const double* orthogonal_coefs) {
  std::vector<double> b = spectral::bernstein_from_orthogonal(order, orthogonal_coefs);
  for (; order < degree; ++order) b = spectral::bernstein_elevate(order, b);
  return b;
}

/// The positions of a straight cell with these vertices.
void set_positions(const std::array<Vec2, 3>& p, Cell& cell) {
  auto& [x, y, u, v] = cell.components;
  x.resize(spectral::num_bernstein(cell.degree));
  y.resize(x.size());
  for (int k = 0, i = 0; k <= cell.degree; ++k)
    for (int j = 0; j + k <= cell.degree; ++j, ++i) {
      const Vec2 at = p[0] + (j * (p[1] - p[0]) + k * (p[2] - p[0])) / cell.degree;
      x[i] = at.x;
      y[i] = at.y;
    }
}

int longest_side(const Cell& cell) {
  int longest = 0;
  double length = 0;
  for (int k = 0; k < 3; ++k) {
    const double d = norm2(cell.vertex((k + 1) % 3) - cell.vertex(k));
    if (d > length) length = d, longest = k;
  }
  return longest;
}

double outside(Vec2 lambda) { return std::max({-lambda.x, -lambda.y, lambda.x + lambda.y - 1}); }

/// The point of the triangle lambda >= 0, lambda1 + lambda2 <= 1 nearest to p.
Vec2 project(Vec2 p) {
  if (outside(p) <= 0) return p;
  const double s = std::clamp((p.x - p.y + 1) / 2, 0.0, 1.0);
  const std::array<Vec2, 3> on_sides{Vec2{std::clamp(p.x, 0.0, 1.0), 0}, Vec2{0, std::clamp(p.y, 0.0, 1.0)},
                                     Vec2{s, 1 - s}};
  return *std::min_element(on_sides.begin(), on_sides.end(),
                           [&](Vec2 a, Vec2 b) { return norm2(a - p) < norm2(b - p); });
}

Vec2 value(const field::FieldEvaluator& evaluator, const Cell& cell, Vec2 lambda) {
  Vec2 x;
  Mat2 dx_dxi;
  return evaluator.value(cell.elem, cell.xi_at(lambda), x, dx_dxi);
}

Vec2 local_coordinates(const Cell& cell, Vec2 xi) {
  const Vec2 a = cell.xi[1] - cell.xi[0], b = cell.xi[2] - cell.xi[0];
  return inverse(Mat2{a.x, b.x, a.y, b.y}) * (xi - cell.xi[0]);
}

}  // namespace

Cell element_cell(const field::FieldEvaluator& evaluator, int elem) {
  const Field& field = evaluator.field();
  const spectral::TriMap& map = evaluator.maps()[elem];
  const int order = field.elem_order[elem], offset = field.coef_offsets[elem];
  Cell cell;
  cell.elem = elem;
  cell.degree = std::max(order, map.order());
  cell.xi = {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}};
  cell.is_straight = map.order() == 1;
  if (cell.is_straight) {
    set_positions({map.position(cell.xi[0]), map.position(cell.xi[1]), map.position(cell.xi[2])}, cell);
  } else {
    cell.components[0] = of_degree(cell.degree, map.order(), map.coefs_x().data());
    cell.components[1] = of_degree(cell.degree, map.order(), map.coefs_y().data());
  }
  cell.components[2] = of_degree(cell.degree, order, &field.u[offset]);
  cell.components[3] = of_degree(cell.degree, order, &field.v[offset]);
  double scale2 = 0;
  for (int i = 0; i < cell.num_coefs(); ++i) scale2 = std::max(scale2, norm2(cell.value(i)));
  cell.scale = std::sqrt(scale2);
  return cell;
}

bool touches_edge(const Cell& cell, int k) {
  return std::any_of(cell.xi.begin(), cell.xi.end(), [k](Vec2 xi) {
    return k == 0 ? xi.y == -1 : k == 1 ? xi.x + xi.y == 0 : xi.x == -1;
  });
}

void bisect(const Cell& cell, Cell& first, Cell& second) {
  const int edge = longest_side(cell), from = edge, to = (edge + 1) % 3;
  first.elem = second.elem = cell.elem;
  first.degree = second.degree = cell.degree;
  first.scale = second.scale = cell.scale;
  first.is_straight = second.is_straight = cell.is_straight;
  first.xi = second.xi = cell.xi;
  first.xi[to] = second.xi[from] = 0.5 * (cell.xi[from] + cell.xi[to]);
  if (cell.is_straight) {
    std::array<Vec2, 3> p{cell.vertex(0), cell.vertex(1), cell.vertex(2)}, q = p;
    p[to] = q[from] = 0.5 * (cell.vertex(from) + cell.vertex(to));
    set_positions(p, first);
    set_positions(q, second);
  }
  for (int c = cell.is_straight ? 2 : 0; c < 4; ++c) {
    first.components[c].resize(cell.num_coefs());
    second.components[c].resize(cell.num_coefs());
    spectral::bernstein_bisect(cell.degree, cell.components[c].data(), edge, first.components[c].data(),
                               second.components[c].data());
  }
}

bool polish_zero(const std::function<field::FieldSample(Vec2 xi)>& sample, Vec2& xi) {
  double last = 1;
  for (int iteration = 0; iteration < 20; ++iteration) {
    const field::FieldSample s = sample(xi);
    const Mat2 dv_dxi = s.dv_dx * s.dx_dxi;
    if (!(std::abs(det(dv_dxi)) > 0)) return false;
    const Vec2 step = inverse(dv_dxi) * s.value;
    const double length = norm(step);
    if (!(length < 1)) return false;
    if (length >= last / 2 && last < 1e-8) return true;  // round-off prevents any further progress
    xi = xi - step;
    last = length;
    if (length < 1e-16) return true;
  }
  return last < 1e-8;
}

bool find_cell_zero(const field::FieldEvaluator& evaluator, const Cell& cell, const Mat2& inverse_jacobian,
                    double contraction, double value_noise, Vec2& xi) {
  const double noise = frobenius_norm(inverse_jacobian) * value_noise, reach = inside_tol + 4 * noise;
  Vec2 lambda{1.0 / 3, 1.0 / 3};
  Vec2 step = inverse_jacobian * value(evaluator, cell, lambda);
  const double to_vertices = std::sqrt(5.0) / 3;
  if (norm(step) > (1 + contraction) * to_vertices + reach) return false;
  for (int iteration = 0; iteration < 200; ++iteration) {
    const Vec2 next = project(lambda - step);
    const double moved = distance(lambda, next);
    lambda = next;
    step = inverse_jacobian * value(evaluator, cell, lambda);
    if (moved < 1e-7 + noise) break;
  }
  // If the fixed point lies on the cell's edge, the zero of the extended polynomial lies beyond it.
  if (norm(step) > 1e-5 + 10 * noise) return false;
  xi = cell.xi_at(lambda);
  const auto sample = [&](Vec2 at) { return evaluator.sample(cell.elem, at); };
  return polish_zero(sample, xi) && outside(local_coordinates(cell, xi)) <= reach;
}

}  // namespace quadrille::zeros
