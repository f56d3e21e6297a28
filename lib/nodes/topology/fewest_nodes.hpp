#pragma once
// No irregular node inside, or as few as possible: by corner valences, by merging nodes of opposite index, and in the
// wakes of an O-grid.

#include <vector>

#include "guide/override_corners.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

/// The corners whose valences change. A corner may have its present valence, or any whose blocks have 40 to 140
/// degrees; one that was prescribed or divided keeps its valence, and corners that symmetries of the face map onto each
/// other have the same. Among these choices:
///   1. the least index that is left for nodes inside, |4 chi - sum (2 - V)|,
///   2. the least angle defect, sum V |omega / (90 V) - 1|^2, omega in degrees,
///   3. changes where the adjacent sides are longest (the sum over the changed corners),
/// each equal within 1e-6; then the corners that come first in the file keep their valences.
std::vector<guide::CornerOverride> corners_without_nodes(const CadFace& face, const CriticalPoints& points);

/// Whether a region has nodes of both signs, of which keep_fewest_nodes merges some. `region_elems`: of the mesh that
/// has the nodes (model/tri_mesh).
bool has_opposite_nodes(const CriticalPoints& points, const std::vector<int>& region_elems);

/// As long as there are nodes of both signs, merges the two of opposite index that are nearest to each other. Pairs at
/// equal distances (within 1e-6 diameters) are merged together, and pairs that share a node as one: one node of the
/// total index replaces them, or a symmetric set if its valence would be above `max_valence` (guide/resolve_clusters),
/// or none if the total is 0. So the nodes are as symmetric as before. Nodes of divided corners stay. Each merger is
/// recorded as a change of the kind `cancel`; the form is then `phase`. Returns whether there was one.
bool keep_fewest_nodes(const CadFace& face, int max_valence, CriticalPoints& points);

/// A corner of a hole that is too sharp for two blocks has valence 3 in an O-grid (topology/grid_kind), which leaves
/// index 1 for a node of valence 3. It belongs into the wake, while the least energy may lie upstream, where lines wind
/// around the body. If such corners account for all index that is left, their nodes replace all others (but those of
/// divided corners): each on the corner's bisector, twice the size of its loop away, at most half of the way to the
/// boundary there. They get the source `corner`, and a change of this kind is recorded. Returns whether nodes were set.
bool set_wake_nodes(const CadFace& face, CriticalPoints& points);

}  // namespace quadrille::topology
