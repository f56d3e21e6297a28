#pragma once
// The centre of a multiple zero, which does not depend on how noise splits the zero.
//
// Let A and B be the analytic parts of the field (guide/circle_samples), c_k its Fourier coefficients on a circle of
// radius R about z0. If one of them, c_n with n the index, outweighs all others, the circle contains n zeros of about
// A_n (z - z0)^n + A_{n-1} (z - z0)^{n-1} + ..., whose centroid is z0 - A_{n-1} / (n A_n) (Vieta); for n < 0 the same
// with conj(w). An error e of the field moves it by e / (n |c_n|) R only, while it splits the zero by e^(1/n).

#include <optional>

#include "field/evaluate.hpp"

namespace quadrille::guide {

/// The centroid of the zeros about `centre` whose indices sum to `index`, |index| >= 2, from the largest circle with a
/// radius between `inner` and `outer` that lies in the mesh and on which the coefficient of `index` has nine tenths of
/// the power. std::nullopt if there is no such circle, or if the centroid is farther than `inner` from `centre`.
std::optional<Vec2> moment_centre(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double inner,
                                  double outer);

}  // namespace quadrille::guide
