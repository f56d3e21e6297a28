#pragma once
// Edges that are too short to be kept.

#include <vector>

#include "heal/joint_limit.hpp"

namespace quadrille::heal {

/// For each edge of the wire, whether it is removed. Consecutive edges shorter than `length` are removed together if
/// their lengths add up to no more than that, and if the edges beside them can be joined. A wire is never removed.
std::vector<bool> short_edges(const std::vector<MeasuredEdge>& wire, double length, const JointLimit& limit);

}  // namespace quadrille::heal
