#pragma once
// Elements in which neither the field nor any that is close to it has a zero.

#include "field/evaluate.hpp"

namespace quadrille::zeros {

/// Whether each field that differs by at most `margin` from this one on element `elem` has no zero there. A proof, made
/// with few cells: it may fail although there is none. For continuous fields.
bool is_surely_empty(const field::FieldEvaluator& evaluator, int elem, double margin);

}  // namespace quadrille::zeros
