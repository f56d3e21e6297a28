#pragma once
// Replaces clusters of zeros by irregular nodes that a layout can use (lib/method.md §5).

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// Adds nodes for every cluster with index != 0: one of valence 4 - index if that is 3 to max_valence; else |index|
/// nodes of valence 3 or 5 about the centre, as symmetric as the face is about it (rules in guide/node_ring). A cluster
/// of index 0 cancels. Centres within 1e-6 diameters of a fixed point of the face's symmetries are moved onto it, and
/// clusters in one symmetry orbit are resolved alike. Nodes get the source `cluster`, or `cancel` if the cluster is far
/// from the boundary: these are never moved, because polygons of one size and orientation in all places of a pattern
/// make a regular layout, which the least energy does not. Changes have the same kinds; those of index 0 are of the
/// kind `cancel`. No elements are set.
void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points);

}  // namespace quadrille::guide
