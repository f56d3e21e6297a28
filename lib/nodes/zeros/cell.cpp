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

/// A linear function in the Bernstein form of degree `degree`, with these values at the vertices.
std::vector<double> linear(int degree, double at0, double at1, double at2) {
  std::vector<double> b;
  b.reserve(spectral::num_bernstein(degree));
  for (int k = 0; k <= degree; ++k)
    for (int j = 0; j + k <= degree; ++j) b.push_back(at0 + (j * (at1 - at0) + k * (at2 - at0)) / degree);
  return b;
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

}  // namespace

Cell element_cell(const field::FieldEvaluator& evaluator, int elem) {
  const Field& field = evaluator.field();
  const spectral::TriMap& map = evaluator.maps()[elem];
  const int order = field.elem_order[elem], offset = field.coef_offsets[elem];
  Cell cell;
  cell.elem = elem;
  cell.degree = std::max(order, map.order());
  cell.xi = {Vec2{-1, -1}, Vec2{1, -1}, Vec2{-1, 1}};
  if (map.order() == 1) {
    const std::array<Vec2, 3> p{map.position(cell.xi[0]), map.position(cell.xi[1]), map.position(cell.xi[2])};
    cell.components[0] = linear(cell.degree, p[0].x, p[1].x, p[2].x);
    cell.components[1] = linear(cell.degree, p[0].y, p[1].y, p[2].y);
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
  first.xi = second.xi = cell.xi;
  first.xi[to] = second.xi[from] = 0.5 * (cell.xi[from] + cell.xi[to]);
  for (int c = 0; c < 4; ++c) {
    first.components[c].resize(cell.num_coefs());
    second.components[c].resize(cell.num_coefs());
    spectral::bernstein_bisect(cell.degree, cell.components[c].data(), edge, first.components[c].data(),
                               second.components[c].data());
  }
}

}  // namespace quadrille::zeros
