#pragma once
// Makes the edges of one wire meet.

#include <vector>

#include "heal/heal_scale.hpp"
#include "heal/joint_limit.hpp"
#include "model/repair.hpp"

namespace quadrille::heal {

/// The edges of the wire with their ends moved to one point where they lie further apart than rounding, each vertex at
/// the ends of its curves; adds what changed to `repairs`. All joints are computed from the old curves, so that their
/// order does not matter. Throws FormatError for a joint that cannot be made within the limit.
std::vector<RawEdge> join_wire(const std::vector<MeasuredEdge>& wire, const HealScale& scale, const JointLimit& limit,
                               std::vector<Repair>& repairs);

}  // namespace quadrille::heal
