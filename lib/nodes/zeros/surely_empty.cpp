#include "zeros/surely_empty.hpp"

#include "zeros/enclosure.hpp"

namespace quadrille::zeros {
namespace {

constexpr int most_bisections = 4;

bool is_cell_empty(const field::FieldEvaluator& evaluator, const Cell& cell, double margin, int bisections) {
  Enclosure enclosure;
  enclosure.set(cell, evaluator.field().liftings, margin);
  if (enclosure.excludes_zero()) return true;
  if (bisections == 0) return false;
  Cell first, second;
  bisect(cell, first, second);
  return is_cell_empty(evaluator, first, margin, bisections - 1) &&
         is_cell_empty(evaluator, second, margin, bisections - 1);
}

}  // namespace

bool is_surely_empty(const field::FieldEvaluator& evaluator, int elem, double margin) {
  if (margin >= 1) return false;
  return is_cell_empty(evaluator, element_cell(evaluator, elem), margin, most_bisections);
}

}  // namespace quadrille::zeros
