#pragma once
// Irregular nodes as a regular polygon about a point, with the symmetry of the face about that point.

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

}  // namespace quadrille::guide
