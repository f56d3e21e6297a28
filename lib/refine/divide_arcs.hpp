#pragma once
// How many elements each chord gets, and where on each arc they end.
//
// A chord's count starts from the wanted size: its longest arc gets intervals of at most `size`. Then every boundary
// arc is tried: the order-N polynomial through an interval's Gauss-Lobatto-Legendre points (by arc length) must stay
// within `tolerance` of the curve. Where it does not and the interval straddles a break of the curve (a joint inside
// the side, a jump of curvature), an end of an interval moves onto the break; else that segment gets more intervals.
// Arcs of one chord share the count, not the places: each arc has its own ends where it needs them.

#include <vector>

#include "curve/chain.hpp"
#include "model/block_layout.hpp"

namespace quadrille {

struct DivideOptions {
  double size = 0;       ///< wanted length of an interval, > 0; segments between breaks may exceed it by a quarter
  int order = 4;         ///< N
  double tolerance = 0;  ///< greatest distance between an interval's polynomial and its curve, > 0, same unit as size
};

/// For each arc the ends of its intervals as fractions of its length, ascending from 0 to 1; arcs of one chord
/// (`arc_chord`, mesh/chords) get the same number. `chains`: one per arc. Throws ComputeError when a boundary arc would
/// need more than 10000 intervals, with its place.
std::vector<std::vector<double>> divide_arcs(const BlockLayout& layout, const std::vector<int>& arc_chord,
                                             const std::vector<Chain>& chains, const DivideOptions& options);

/// Greatest sampled distance between the chain on [low, high] and the order-N polynomial through its points at
/// Gauss-Lobatto-Legendre fractions: taken at equal fractions, so never below the distance between the two curves.
double interval_error(const Chain& chain, double low, double high, int order);

}  // namespace quadrille
