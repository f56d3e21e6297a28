#pragma once
// What the term that aligns crosses (field/alignment_term.hpp), -Δv + mu v = f, asks of each form of the field.

#include <Eigen/Dense>
#include <vector>

#include "field/alignment_term.hpp"
#include "galerkin/discretization.hpp"
#include "model/field.hpp"

namespace quadrille::galerkin {

/// Liftings L are harmonic: the polynomials beside them have f - mu L. `liftings`: of each vector function, two columns
/// each; `has_target`: whether f counts, or the equation is that of what is added to a field, with f = 0. `term` and
/// `liftings` must outlive the result.
ValuesInElement right_side_beside(const field::AlignmentTerm& term,
                                  const std::vector<const std::vector<Lifting>*>& liftings, bool has_target);

/// Adds to the phase phi = explicit part + s the function c, 0 on the boundary, with which
///
///   E = 1/2 int |grad (phi + c)|^2 + int mu - |f| cos(phi + c - arg f)
///
/// is least. Since the second derivative of the last term is at most mu, the solution of -Δc' + mu c' = mu c + Im(f
/// e^(-i (phi + c))) lowers E: the equation of v for a unit field, without a choice of branches. `coefs`: of s by
/// element; `system`: with the term, for the orders of s.
void align_phase(const MeshContext& context, ContinuousSystem& system, const field::AlignmentTerm& term,
                 const PhaseTerms& terms, Stopwatch& watch, std::vector<Eigen::MatrixXd>& coefs);

}  // namespace quadrille::galerkin
