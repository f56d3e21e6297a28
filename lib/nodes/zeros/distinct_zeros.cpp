#include "zeros/distinct_zeros.hpp"

#include <algorithm>

namespace quadrille::zeros {
namespace {

constexpr double inside_tol = 1e-8;  // in barycentric coordinates, as in cell_zero

bool is_inside(const FoundZero& zero) { return mesh::outside_reference(zero.xi) <= inside_tol; }

bool is_same(const FoundZero& a, const FoundZero& b, double diameter) {
  const double reach = 1e-3 * std::min(a.cell_radius, b.cell_radius) + 8 * std::max(a.shift, b.shift);
  return a.index == b.index && distance(a.x, b.x) <= reach + 1e-12 * diameter;
}

}  // namespace

std::vector<FoundZero> distinct_zeros(const field::FieldEvaluator& evaluator, const std::vector<FoundZero>& zeros) {
  const double diameter = evaluator.field().mesh.face.diameter;
  std::vector<FoundZero> result;
  for (const bool inside : {true, false})
    for (const FoundZero& zero : zeros) {
      if (is_inside(zero) != inside) continue;
      const bool known = std::any_of(result.begin(), result.end(),
                                     [&](const FoundZero& other) { return is_same(zero, other, diameter); });
      if (known) continue;
      if (inside || evaluator.locator().find(zero.x).elem >= 0) result.push_back(zero);
    }
  return result;
}

std::vector<OpenCell> cells_without_zero(const std::vector<OpenCell>& open_cells, const std::vector<FoundZero>& zeros) {
  std::vector<OpenCell> result;
  for (const OpenCell& cell : open_cells) {
    const bool is_explained = std::any_of(zeros.begin(), zeros.end(), [&](const FoundZero& zero) {
      return distance(cell.centre, zero.x) + cell.radius <= 8 * zero.shift;
    });
    if (!is_explained) result.push_back(cell);
  }
  return result;
}

}  // namespace quadrille::zeros
