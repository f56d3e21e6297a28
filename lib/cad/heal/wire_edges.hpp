#pragma once
// The edges of wires: those that are too short, their order, and the wires that edges without a face make.

#include <string>
#include <vector>

#include "heal/heal_rules.hpp"
#include "heal/joint_target.hpp"
#include "heal/raw_face.hpp"

namespace quadrille::heal {

/// For each edge of the wire, whether it is removed. Consecutive edges shorter than `length` are removed together if
/// their lengths add up to no more than that, and if the edges beside them can be joined. A wire is never removed.
std::vector<bool> short_edges(const std::vector<MeasuredEdge>& wire, double length, const JointLimit& limit);

/// The edges in the order of the wire: each next edge is the first one that starts within `near` of the end of the
/// previous edge, or else the one that starts nearest to it, within `tol` (lengths). Vertices count as well as ends of
/// curves. Throws FormatError if no edge follows, or if the wire does not close. `file`: for the message.
std::vector<const RawEdge*> chain_edges(const std::vector<const RawEdge*>& edges, double near, double tol,
                                        const std::string& file);

// Curves that were drawn without a face: the wires that they make.

/// Makes closed wires of the edges of all wires, which may have any order and direction: edges follow each other where
/// their ends, and no other, are within the tolerance, and are turned round where necessary. Each wire begins with its
/// first edge, in the direction of that. Throws FormatError, with the edge, the place, the size and a remedy, where the
/// curves leave a gap or more than two of them meet.
void close_wires(RawFace& raw, const HealScale& scale);

}  // namespace quadrille::heal
