#pragma once
// Replaces clusters of zeros by irregular nodes that a layout can use (lib/method.md §5): one at the centre, or a
// regular polygon about it with the symmetry of the face about that point.

#include <cstddef>
#include <functional>
#include <vector>

#include "curve/symmetry.hpp"
#include "model/cad_face.hpp"
#include "model/critical_points.hpp"

namespace quadrille::guide {

/// The point x, or if it lies within 1e-6 diameters of the rotation centre or of a mirror axis, the nearest point
/// there.
Vec2 onto_fixed_points(const CadFace& face, const std::vector<curve::Isometry>& group, Vec2 x);

/// The positions of |index| nodes of index 1 or -1 about cluster.centre: a regular polygon.
///
/// Orientation. The isometries that keep the centre form a group C_n or D_n. The polygon must have the rotations of
/// this group as far as |index| allows, which is true for any orientation, and its mirrors: a vertex or the middle of a
/// side lies on an axis. Without a mirror, a vertex or the middle of a side points towards a nearest boundary point. Of
/// these:
///   1. the nearest to the members' own positions, if there are |index| of them, all of one sign and farther from the
///      centre than noise of 1e-8 in the field can split a multiple zero: 1e-8^(1/|index|) of the clearance;
///      without any mirror just the mean orientation of these positions;
///   2. vertices with the greatest clearance along their rays for index > 0, with the least for index < 0: nodes of
///      valence 3 belong to convex corners, far away, those of valence 5 to reflex ones, which are near;
///   3. a vertex nearest to the direction of joint 0.
///
/// Radius. Half the distance to the boundary, at most a third of the distance to the nearest of `others`. About a
/// centre outside the face (in a hole) the radius with the greatest clearance of all nodes.
std::vector<Vec2> node_ring(const CadFace& face, const std::vector<curve::Isometry>& group, const Cluster& cluster,
                            const std::vector<Vec2>& others);

/// The nodes for a cluster of index != 0: one at its centre if 4 - index is 3 to max_valence and the centre lies inside
/// the face, else a node_ring.
std::vector<NodeMark> cluster_nodes(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                                    const Cluster& cluster, const std::vector<Vec2>& others);

/// The same of each cluster, none for index 0; `others` of cluster i are others(i). Centres are moved onto fixed
/// points; clusters of one symmetry orbit get centres and nodes that are exact images of each other.
std::vector<std::vector<NodeMark>> nodes_of_clusters(const CadFace& face, const std::vector<curve::Isometry>& group,
                                                     int max_valence, std::vector<Cluster>& clusters,
                                                     const std::function<std::vector<Vec2>(std::size_t)>& others);

/// Adds nodes for every cluster with index != 0: one of valence 4 - index if that is 3 to max_valence; else |index|
/// nodes of valence 3 or 5 about the centre, as symmetric as the face is about it (node_ring). A
/// cluster of index 0 cancels. Centres within 1e-6 diameters of a fixed point of the face's symmetries are moved onto
/// it, and clusters in one symmetry orbit are resolved alike. Nodes get the source `cluster`, or `cancel` if the
/// cluster is far from the boundary: these are never moved, because polygons of one size and orientation in all places
/// of a pattern make a regular layout, which the least energy does not. Changes have the same kinds; those of index 0
/// are of the kind `cancel`. No elements are set. `group`: the isometries of the face.
void resolve_clusters(const CadFace& face, const std::vector<curve::Isometry>& group, int max_valence,
                      CriticalPoints& points);
void resolve_clusters(const CadFace& face, int max_valence, CriticalPoints& points);

}  // namespace quadrille::guide
