#pragma once
// Zeros that the field does not decide: they lie in one region in which |v| is below the error of the field.
//
// elem_error estimates the error of an element; it is no bound there. But the error v - v_h is harmonic up to what the
// elements do not resolve, so that by the maximum principle the greatest elem_error bounds it everywhere, which is what
// counts here. Crude fields have errors that exceed |v| about zeros that are real: the error taken is at most 1e-6, the
// part of |v| = 1 below which values count as equal (lib/README.md, "Invariants"). Where |v_h| <= e the exact field may
// be any small vector, and zeros that such a region connects may all exist, or cancel each other. On its rim |v_h| > e,
// so that the sum of their indices, the winding of v along the rim, is that of the exact field.
//
// Such regions are long and thin where one component of v almost vanishes: along the curve on which the other one is 0.

#include <vector>

#include "zeros/zero_search.hpp"

namespace quadrille::zeros {

/// Constants of the search for regions.
struct RegionLimits {
  double greatest_error = 1e-6;  ///< of v, whose magnitude is 1 on the boundary
  double soft = 4;               ///< |v| between two zeros is about sigma d / 4: candidates have sigma d <= soft e
  double resolution = 1.0 / 16;  ///< radius of the smallest cells, relative to the distance of the two nearest zeros
  std::size_t most_cells = 4000;
};

/// e, the greatest elem_error, at most `limits.greatest_error`; 0 if errors are not estimated.
double undecided_below(const Field& field, const RegionLimits& limits = {});

/// Groups of two zeros or more, as ascending indices into `zeros`, each connected by a region with |v| <= `error`. A
/// region is enclosed by cells in which |v| > `error` is proved. It starts at a zero whose least singular value sigma
/// of dv/dx, times the distance d to the nearest other zero, does not exceed 4 `error`; for all other zeros sigma d is
/// greater by orders of magnitude, and nothing is searched. A group may be found from several of its zeros. Regions
/// that reach the boundary, where |v| = 1 except at corners, and those of more than 4000 cells connect nothing.
std::vector<std::vector<int>> undecided_zeros(const field::FieldEvaluator& evaluator,
                                              const std::vector<FoundZero>& zeros, double error,
                                              const RegionLimits& limits = {});

}  // namespace quadrille::zeros
