#pragma once
// Where the irregular nodes come from (formats/critical-points.md): the search for zeros, clusters, what was changed.
// Each function adds legend entries for what occurs, and nothing where there is nothing.

#include <vector>

#include "draw/picture.hpp"
#include "model/critical_points.hpp"

namespace quadrille::draw {

/// Cells in which the search ended, undecided ones in another colour, and the discs left to corners; only what lies in
/// `face`, where it is not null.
void draw_certificate(Picture& picture, const Certificate& certificate, const CadFace* face);

/// A dashed circle about each cluster, at least as large as a mark, with its index beside it. Hover: members, radius.
void draw_clusters(Picture& picture, const std::vector<Cluster>& clusters, Vec2 origin);

/// Thin arrows from what was there before to what is there after, hollow marks where nodes were, crosses where they
/// cancelled, a ring where both are too near to each other for an arrow. Hover: kind and reason.
void draw_changes(Picture& picture, const std::vector<NodeChange>& changes);

}  // namespace quadrille::draw
