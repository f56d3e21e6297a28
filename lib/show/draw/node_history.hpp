#pragma once
// Draws the origin of the irregular nodes (formats/critical-points.md): the search for zeros, clusters, changes. Each
// function adds legend entries for what occurs; it draws nothing if nothing occurs.

#include <vector>

#include "draw/picture.hpp"
#include "model/critical_points.hpp"

namespace quadrille::draw {

/// Cells in which the search ended, undecided ones in another colour, and the discs around corners that the search
/// omits; only those inside `face`, unless it is null.
void draw_certificate(Picture& picture, const Certificate& certificate, const CadFace* face);

/// A dashed circle about each cluster, at least as large as a mark, with its index beside it. Hover: members, radius.
void draw_clusters(Picture& picture, const std::vector<Cluster>& clusters, Vec2 origin);

/// Draws each change: thin arrows from the nodes before to the nodes after, hollow marks at former positions, crosses
/// where nodes cancelled, a ring where both are too close for an arrow. Hover: kind and reason.
void draw_changes(Picture& picture, const std::vector<NodeChange>& changes);

}  // namespace quadrille::draw
