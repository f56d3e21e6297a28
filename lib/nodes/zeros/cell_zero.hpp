#pragma once
// The zero of the guiding field in a cell that contains at most one.

#include "zeros/cell.hpp"

namespace quadrille::zeros {

/// Finds the zero, or proves that there is none. `inverse_jacobian` and `contraction` < 1 as from Enclosure::isolates:
/// then lambda -> P(lambda - inverse_jacobian v(lambda)), P the projection onto the cell, is a contraction of the cell,
/// and a zero in the cell is its fixed point. Newton's method improves the result. A zero beyond the cell's edge by at
/// most 1e-8 of its size, or by the distance that `value_noise` can move it, counts as inside, so that none is lost
/// between neighbours. Returns whether a zero was found; `xi` are then its reference coordinates.
bool find_cell_zero(const field::FieldEvaluator& evaluator, const Cell& cell, const Mat2& inverse_jacobian,
                    double contraction, double value_noise, Vec2& xi);

/// Newton's method for v = 0 on the polynomial of `elem`, from xi; the result may lie outside `elem`. False if it
/// diverges.
bool polish_zero(const field::FieldEvaluator& evaluator, int elem, Vec2& xi);

}  // namespace quadrille::zeros
