#pragma once
// A part of an element in the search for zeros: geometry and polynomial part of the field in Bernstein form.
//
// A cell is a triangle in the element's reference coordinates, with local coordinates lambda = (lambda1, lambda2) of
// its vertices 1 and 2: lambda >= 0, lambda1 + lambda2 <= 1. Position and field are polynomials in lambda of one common
// degree, so that curved elements are not a special case.

#include <array>
#include <functional>
#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::zeros {

struct Cell {
  int elem = 0;
  int degree = 1;
  bool is_straight = false;  ///< the element is affine, so that the cell is the triangle of its vertices
  double scale = 0;          ///< greatest coefficient of the element's field, the scale of rounding errors
  std::array<Vec2, 3> xi;    ///< vertices in the element's reference coordinates
  std::array<std::vector<double>, 4> components;  ///< x, y, u, v without liftings

  int num_coefs() const { return static_cast<int>(components[0].size()); }
  Vec2 point(int i) const { return {components[0][i], components[1][i]}; }
  Vec2 value(int i) const { return {components[2][i], components[3][i]}; }
  /// Position of vertex k, exactly the value of the polynomial.
  Vec2 vertex(int k) const { return point(k == 0 ? 0 : k == 1 ? degree : num_coefs() - 1); }
  Vec2 xi_at(Vec2 lambda) const { return xi[0] + lambda.x * (xi[1] - xi[0]) + lambda.y * (xi[2] - xi[0]); }
};

struct Disc {
  Vec2 centre;
  double radius = 0;
};

/// An upper bound of the greatest stretch of a vector by m.
inline double frobenius_norm(const Mat2& m) { return std::sqrt(m.xx * m.xx + m.xy * m.xy + m.yx * m.yx + m.yy * m.yy); }

/// The whole element `elem`.
Cell element_cell(const field::FieldEvaluator& evaluator, int elem);

/// Whether a vertex of the cell lies on local edge k of its element, without a tolerance: bisection is exact.
bool touches_edge(const Cell& cell, int k);

/// Bisects the cell at the middle of its longest side in the plane.
void bisect(const Cell& cell, Cell& first, Cell& second);

/// A point counts as inside if it lies beyond an edge by no more, in barycentric coordinates.
inline constexpr double inside_tol = 1e-8;

/// Finds the zero of a cell that contains at most one, or proves that the cell has no zero. `inverse_jacobian` and
/// `contraction` < 1 as from Enclosure::isolates: then lambda -> P(lambda - inverse_jacobian v(lambda)), P the
/// projection onto the cell, is a contraction of the cell, and a zero in the cell is its fixed point. Newton's method
/// improves the result. A zero beyond the cell's edge by at most inside_tol of its size, or by the distance that
/// `value_noise` can move it, counts as inside, so that none is lost between neighbours. Returns whether a zero was
/// found; `xi` are then its reference coordinates.
bool find_cell_zero(const field::FieldEvaluator& evaluator, const Cell& cell, const Mat2& inverse_jacobian,
                    double contraction, double value_noise, Vec2& xi);

/// Newton's method for v = 0 on the polynomial of an element, from xi; the result may lie outside the element. False if
/// it diverges, or takes a step of half an element.
bool polish_zero(const std::function<field::FieldSample(Vec2 xi)>& sample, Vec2& xi);

}  // namespace quadrille::zeros
