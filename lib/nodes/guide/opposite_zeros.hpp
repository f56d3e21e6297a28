#pragma once
// Zeros of opposite index that are nearer to each other than to the boundary, so that fewer nodes can replace them.
//
// Two zeros are linked if their indices are opposite, they are nearer to each other than 0.6 of the distance of one of
// them to the boundary, and the nearest to this one is nearer than 0.4 of that distance. Linked zeros form a group
//   - if the indices of one of them and all that are linked through its distance add up to -1, 0 or 1, so that one node
//     or none replaces them; or
//   - if their total index is greater and a circle in the face encloses the group, and perhaps other groups or zeros,
//     on which one analytic part of the field outweighs the other (guide/circle_samples): A where the index is
//     positive, B where it is negative. By the theorem of Rouche that part alone has the whole index inside, in zeros
//     of one sign; the other part only adds opposite pairs. This happens where a zero of high order would lie but for a
//     small asymmetry, as between holes in rows.

#include <vector>

#include "field/evaluate.hpp"
#include "zeros/zero_search.hpp"

namespace quadrille::guide {

/// The groups: ascending numbers of their zeros, of both signs. Lengths equal within 1e-6 count as equal. Cost:
/// quadratic in the number of zeros.
std::vector<std::vector<int>> opposite_zeros(const field::FieldEvaluator& evaluator,
                                             const std::vector<zeros::FoundZero>& zeros);

}  // namespace quadrille::guide
