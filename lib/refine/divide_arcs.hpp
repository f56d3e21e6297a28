#pragma once
// How many elements each chord gets, and where on each arc they end.
//
// A chord's count starts from the wanted size: its longest arc gets intervals of at most `size`. Then every boundary
// arc is tried: the order-N polynomial through an interval's Gauss-Lobatto-Legendre points (by arc length) must stay
// within `tolerance` of the curve. Where it does not and the interval straddles a break of the curve (a joint inside
// the side, a jump of curvature), an end of an interval moves onto the break; else that segment of the chord gets more
// intervals. All arcs of the chord share the segments; a break that faces another (refine/anchors) costs no element of
// its own.

#include <vector>

#include "curve/chain.hpp"
#include "mesh/chords.hpp"
#include "model/block_layout.hpp"
#include "refine/arc_parameter.hpp"

namespace quadrille {

struct DivideOptions {
  double size = 0;       ///< wanted length of an interval, > 0; segments between breaks may exceed it by a quarter
  int order = 4;         ///< N
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, same unit as size
};

/// For each arc the ends of its intervals as fractions of its length, ascending from 0 to 1; arcs of one chord get the
/// same number, equally spaced between breaks in their `parameters` (refine/align_chords). `chains`, `parameters`: one
/// per arc. Throws ComputeError when a chord would need more than 10000 intervals, with its place.
std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<Chord>& chords,
                                             const CurveTable& table, const std::vector<Chain>& chains,
                                             const std::vector<ArcParameter>& parameters, const DivideOptions& options);

/// Greatest sampled distance between the chain and the order-N polynomial through its points at Gauss-Lobatto-Legendre
/// fractions of [low, high]: of the polynomial from the chain, and of the chain's breaks from the polynomial. `table`:
/// the chain's own.
double interval_error(const CurveTable& table, const Chain& chain, double low, double high, int order);

}  // namespace quadrille
