#pragma once
// The same nodes on both arcs of a periodic pair.
//
// Both arcs belong to one chord, so they have the same number of elements. Their own divisions differ where the blocks
// beside them do; each then gets the mean of both.

#include <vector>

#include "model/periodic.hpp"
#include "sizing/arc_division.hpp"

namespace quadrille::refine {

/// Replaces rising fractions from 0 to 1 of both arcs, each in the arc's own direction, by their means; lists of
/// different lengths are not changed.
void match_fractions(const PeriodicArcs& arcs, std::vector<double>& first, std::vector<double>& second);

/// The divisions of all pairs, and the nodes of arcs with layers (by arc; empty where they follow from the
/// division, and for all arcs of a mesh without layers).
void match_periodic(const std::vector<PeriodicArcs>& pairs, sizing::ArcDivisions& divisions,
                    std::vector<std::vector<double>>& layered_nodes);

}  // namespace quadrille::refine
