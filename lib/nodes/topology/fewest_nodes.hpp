#pragma once
// As few irregular nodes as the index sum allows: nodes of opposite index are merged.

#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::topology {

/// As long as there are nodes of both signs, merges the two of opposite index that are nearest to each other. Pairs at
/// equal distances (within 1e-6 diameters) are merged together, and pairs that share a node as one: one node of the
/// total index replaces them, or a symmetric set if its valence would be above `max_valence` (guide/node_ring), or none
/// if the total is 0. So the nodes are as symmetric as before. Nodes of divided corners stay. Each merger is recorded
/// as a change of the kind `cancel`; the form is then `phase`. Returns whether there was one.
bool keep_fewest_nodes(const CadFace& face, int max_valence, CriticalPoints& points);

}  // namespace quadrille::topology
