#pragma once
// The field on a circle, and its two analytic parts.
//
// u and v are harmonic, so that inside the circle w = u + i v = A(z) + conj(B(z)), A and B analytic. The Fourier
// coefficients of w on a circle of radius R about z0 are those of the Taylor series of A and B: c_k = A_k R^k for
// k > 0, c_-k = conj(B_k) R^k. The constant belongs to either.

#include <complex>
#include <optional>
#include <vector>

#include "field/evaluate.hpp"

namespace quadrille::guide {

using Complex = std::complex<double>;

/// w at equidistant points of the circle, counter-clockwise from the direction of x; conjugated for a negative index,
/// which exchanges A and B. std::nullopt if one of the points is outside the mesh.
std::optional<std::vector<Complex>> circle_samples(const field::FieldEvaluator& evaluator, Vec2 centre, double radius,
                                                   int index);

/// A with the constant at the sampled points, from the samples w of a positive index; for a negative one B.
std::vector<Complex> analytic_part(const std::vector<Complex>& w);

/// The coefficient c_k of the samples, |k| < half their number.
Complex fourier_coefficient(const std::vector<Complex>& w, int k);

}  // namespace quadrille::guide
