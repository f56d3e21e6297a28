#pragma once
// Where the regions of a face meet: the curves that two regions share, the arcs along them, and the Euler
// characteristic of the whole.
//
// An interface is in the face twice, once for each region (CadFace::partners), and in a graph once: its arcs are not
// boundary arcs, and their pieces lie on the curve of the region with the lower number. Where both sides have boundary
// arcs of their own, the interface is open: nothing crosses it.

#include <algorithm>
#include <vector>

#include "base/disjoint_sets.hpp"
#include "base/point_grid.hpp"
#include "base/tolerance.hpp"
#include "model/arc_graph.hpp"
#include "model/cad_face.hpp"

namespace quadrille {

/// The region of each curve.
inline std::vector<int> curve_regions(const CadFace& face) {
  std::vector<int> regions;
  for (int l = 0; l < face.num_loops(); ++l)
    regions.insert(regions.end(), face.loop_offsets[l + 1] - face.loop_offsets[l], face.region_of_loop(l));
  return regions;
}

/// Whether an arc follows CAD curves: the boundary or an interface. It must have pieces.
inline bool is_on_cad_curve(const ArcGraph& graph, const GraphArc& arc) {
  return arc.pieces.front().curve < graph.face.num_curves();
}

/// Whether an arc follows an interface.
inline bool is_on_interface(const ArcGraph& graph, const GraphArc& arc) {
  return !arc.is_boundary && is_on_cad_curve(graph, arc);
}

/// Whether sizes may jump across an arc: it lies between two faces of the CAD file, not on a curve inside one, which
/// has the same region, or regions of one name, on both sides.
inline bool separates_faces(const ArcGraph& graph, const GraphArc& arc, const std::vector<int>& curve_region) {
  if (!is_on_interface(graph, arc)) return false;
  const int curve = arc.pieces.front().curve;
  const int left = curve_region[curve], right = curve_region[graph.face.partners[curve]];
  return left != right && graph.face.region_names[left] != graph.face.region_names[right];
}

/// The region on the left of a half-edge that follows a CAD curve; -1 for others. A boundary arc has its region on the
/// face's side of its curve, in whichever direction it runs.
inline int region_on_left(const ArcGraph& graph, HalfEdge h, const std::vector<int>& curve_region) {
  const GraphArc& arc = graph.arcs[h.arc];
  if (!is_on_cad_curve(graph, arc)) return -1;
  const ArcPiece& piece = arc.pieces.front();
  const bool is_own_side = arc.is_boundary || h.is_backwards != (piece.t0 < piece.t1);
  return curve_region[is_own_side ? piece.curve : graph.face.partners[piece.curve]];
}

/// A point of a curve, seen from the other region.
struct PartnerPoint {
  int curve = -1;
  double t = 0;
};

/// The same point on the partner of a curve that has one: its knots are mirrored.
inline PartnerPoint partner_point(const CadFace& face, int curve, double t) {
  const int partner = face.partners[curve];
  const Nurbs &own = face.curves[curve], &other = face.curves[partner];
  return {partner, std::clamp(other.begin() + (own.end() - t), other.begin(), other.end())};
}

/// By curve: whether the arcs of a graph close the interface, so that both its sides are one. False on the boundary.
inline std::vector<bool> closed_interfaces(const ArcGraph& graph) {
  std::vector<bool> is_closed(graph.face.curves.size(), false);
  for (const GraphArc& arc : graph.arcs)
    if (is_on_interface(graph, arc))
      for (const ArcPiece& piece : arc.pieces)
        is_closed[piece.curve] = is_closed[graph.face.partners[piece.curve]] = true;
  return is_closed;
}

/// Euler characteristic of the regions put together along the curves of `is_closed` (by curve, both sides alike): of a
/// face of one region without slits, its own.
inline int euler_characteristic_of_whole(const CadFace& face, const std::vector<bool>& is_closed) {
  DisjointSets joints(face.joints.size());
  int num_closed = 0;
  for (int c = 0; c < face.num_curves(); ++c) {
    if (!is_closed[c]) continue;
    ++num_closed;
    joints.unite(c, face.next_in_loop(face.partners[c]));
    joints.unite(face.next_in_loop(c), face.partners[c]);
  }
  const int num_points = static_cast<int>(joints.sets().size());
  return num_points - (face.num_curves() - num_closed / 2) + face.euler_characteristic();
}

/// That of a graph's domain: 4 times it is the index sum.
inline int euler_characteristic_of_whole(const ArcGraph& graph) {
  return euler_characteristic_of_whole(graph.face, closed_interfaces(graph));
}

// The corners of a face around which there is more of the face.

/// By joint: whether more of the face is there than the sector of this joint, or a slit ends there. A slit ends, bends
/// or branches, or a region touches itself: beyond the corner there may be the face again. All sectors of a region in
/// one place are in one loop.
inline std::vector<bool> enclosed_joints(const CadFace& face) {
  std::vector<bool> are_enclosed(face.joints.size(), false);
  for (int l = 0; l < face.num_loops(); ++l) {
    const int first = face.loop_offsets[l];
    std::vector<Vec2> positions;
    for (int j = first; j < face.loop_offsets[l + 1]; ++j) positions.push_back(face.joints[j].position);
    const std::vector<int> places = places_of(positions, tolerance::round_off * face.diameter);
    for (int i = 0; i < static_cast<int>(places.size()); ++i) {
      const int joint = first + i;
      if (places[i] != i) are_enclosed[joint] = are_enclosed[first + places[i]] = true;
      if (face.is_interface(joint) && face.partners[joint] == face.previous_in_loop(joint)) are_enclosed[joint] = true;
    }
  }
  return are_enclosed;
}

}  // namespace quadrille
