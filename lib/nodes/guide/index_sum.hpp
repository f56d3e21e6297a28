#pragma once
// The index sum that every set of nodes and corner valences must have (lib/method.md §1).

#include "model/critical_points.hpp"

namespace quadrille::guide {

/// sum (4 - V) over the nodes, plus the indices of clusters, plus sum (2 - V) over corners and boundary nodes.
int index_sum_with_clusters(const CriticalPoints& points);

/// Throws ComputeError if index_sum != index_sum_expected, with the difference and the corner nearest to a tie.
void require_index_sum(const CriticalPoints& points);

}  // namespace quadrille::guide
