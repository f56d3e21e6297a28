#pragma once
// What the field on a circle says about the zeros inside.
//
// u and v are harmonic, so that inside the circle w = u + i v = A(z) + conj(B(z)), A and B analytic. The Fourier
// coefficients of w on a circle of radius R about z0 are those of the Taylor series of A and B: c_k = A_k R^k for
// k > 0, c_-k = conj(B_k) R^k. The constant belongs to either.
//
// The centre of a multiple zero does not depend on how noise splits the zero. If one of the coefficients, c_n with n
// the index, outweighs all others, the circle contains n zeros of about A_n (z - z0)^n + A_{n-1} (z - z0)^{n-1} + ...,
// whose centroid is z0 - A_{n-1} / (n A_n) (Vieta); for n < 0 the same with conj(w). An error e of the field moves it
// by e / (n |c_n|) R only, while it splits the zero by e^(1/n).
//
// Fewer nodes can replace zeros of opposite index that are nearer to each other than to the boundary. Two zeros are
// linked if their indices are opposite, they are nearer to each other than 0.6 of the distance of one of them to the
// boundary, and the nearest to this one is nearer than 0.4 of that distance. Linked zeros form a group
//   - if the indices of one of them and all that are linked through its distance add up to -1, 0 or 1, so that one node
//     or none replaces them; or
//   - if their total index is greater and a circle in the face encloses the group, and perhaps other groups or zeros,
//     on which one analytic part of the field outweighs the other: A where the index is positive, B where it is
//     negative. By the theorem of Rouche that part alone has the whole index inside, in zeros of one sign; the other
//     part only adds opposite pairs. This happens where a zero of high order would lie but for a small asymmetry, as
//     between holes in rows.

#include <optional>
#include <vector>

#include "curve/face_boundary.hpp"
#include "field/evaluate.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// The centroid of the zeros about `centre` whose indices sum to `index`, |index| >= 2, from the largest circle with a
/// radius between `inner` and `outer` that lies in the mesh and on which the coefficient of `index` has nine tenths of
/// the power. std::nullopt if there is no such circle, or if the centroid is farther than `inner` from `centre`.
std::optional<Vec2> moment_centre(const field::FieldEvaluator& evaluator, Vec2 centre, int index, double inner,
                                  double outer);

/// The groups of zeros that fewer nodes can replace: ascending numbers of their zeros, of both signs. Lengths equal
/// within 1e-6 count as equal. Cost: quadratic in the number of zeros.
std::vector<std::vector<int>> opposite_zeros(const field::FieldEvaluator& evaluator,
                                             const curve::FaceBoundary& boundary,
                                             const std::vector<zeros::FoundZero>& zeros);

}  // namespace quadrille::guide
