#pragma once
// The nodes of an O-grid behind sharp trailing edges.

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

/// A corner of a hole that is too sharp for two blocks has valence 3 in an O-grid (topology/grid_kind), which leaves
/// index 1 for a node of valence 3. It belongs into the wake, while the least energy may lie upstream, where lines wind
/// around the body. If such corners account for all index that is left, their nodes replace all others (but those of
/// divided corners): each on the corner's bisector, twice the size of its loop away, at most half of the way to the
/// boundary there. They get the source `corner`, and a change of this kind is recorded. Returns whether nodes were set.
bool set_wake_nodes(const CadFace& face, CriticalPoints& points);

}  // namespace quadrille::topology
