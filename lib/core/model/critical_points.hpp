#pragma once
// The prescribed irregular nodes of a layout and the valences of corners (formats/critical-points.md, x.crit.json).
// Valence V = 4 - index for an interior node; at a corner or boundary node V counts the blocks in its sector.
//
// The nodes are the zeros of the guiding field, or replace them: clusters resolved, nodes absorbed by corners, put onto
// the boundary, moved, prescribed by hand. `form` states which.

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"
#include "model/cad_face.hpp"
#include "model/phase_nodes.hpp"
#include "model/provenance.hpp"

namespace quadrille {

/// The kind of field that has these nodes. `harmonic`: every node is a zero of the harmonic field, and every corner has
/// the valence of that field. `phase`: later stages need a field of the phase form made for these nodes (fieldsolve
/// --nodes).
enum class NodeForm { harmonic, phase };
constexpr auto enum_names(NodeForm) { return std::to_array({"harmonic", "phase"}); }

/// How nodes and valences were changed. `other`: a kind that a later version of the format added.
enum class ChangeKind { cluster, cancel, absorb, corner, line, divide, feature, place, other };
constexpr auto enum_names(ChangeKind) {
  return std::to_array({"cluster", "cancel", "absorb", "corner", "line", "divide", "feature", "place", "other"});
}

/// The origin of a node or a valence. Nodes: a `zero` of the field or prescribed by `hand`. Corners: the valence
/// nearest to the `angle`, or that of the `field` at a tie. Both: otherwise the last change.
enum class NodeSource {
  zero,
  hand,
  angle,
  field,
  cluster,
  cancel,
  absorb,
  corner,
  line,
  divide,
  feature,
  place,
  other
};
constexpr auto enum_names(NodeSource) {
  return std::to_array({"zero", "hand", "angle", "field", "cluster", "cancel", "absorb", "corner", "line", "divide",
                        "feature", "place", "other"});
}

/// The source of a node that a change of this kind made: the value of the same name.
inline NodeSource source_of(ChangeKind kind) { return *enum_value<NodeSource>(enum_name(kind)); }

enum class NodeLocation { inside, corner, boundary };
constexpr auto enum_names(NodeLocation) { return std::to_array({"inside", "corner", "boundary"}); }

struct CriticalPoint {
  Vec2 position;
  int index = 0;
  int valence = 4;
  int elem = 0;                      ///< element of the field's mesh that contains it
  Vec2 xi;                           ///< reference coordinates there
  std::array<double, 4> jacobian{};  ///< d v / d x at the point: u_x, u_y, v_x, v_y; zeros if it is not a zero of v
  double error = 0;                  ///< error bar |J^-1 e| of the position, e the field's error there; 0: unknown
  NodeSource source = NodeSource::zero;
};

struct Corner {
  int joint = 0;  ///< index into face.joints
  Vec2 position;
  double angle_degrees = 0;
  int valence = 2;
  std::array<int, 2> curves{};            ///< incoming and outgoing
  NodeSource source = NodeSource::angle;  ///< of the valence
};

/// A node on the boundary that is not at a corner: V blocks meet there instead of 2.
struct IrregularBoundaryPoint {
  int curve = 0;
  double t = 0;  ///< parameter, inside the curve or at a smooth joint
  Vec2 position;
  int valence = 3;
  NodeSource source = NodeSource::feature;
};

/// A node before or after a change.
struct NodeMark {
  Vec2 position;
  int valence = 4;
  NodeLocation location = NodeLocation::inside;
};

/// One change of the field's own zeros and valences, with its reason. `before` and `after` have the same index sum.
struct NodeChange {
  ChangeKind kind = ChangeKind::other;
  std::string reason;  ///< a sentence for people
  std::vector<NodeMark> before, after;
};

/// Zeros that are treated as one: a multiple zero, or zeros nearer to each other than any block could be.
struct Cluster {
  Vec2 centre;
  double radius = 0;  ///< of a circle about all members
  int index = 0;      ///< sum of the members
  std::vector<Vec2> members;
  std::vector<int> member_indices;    ///< empty if they cannot be distinguished
  bool is_far_from_boundary = false;  ///< for the distance of its members of opposite index; not in the file
  bool is_undecided = false;          ///< the field does not decide whether the members exist; not in the file
};

/// What the search proved about a cell. `zero`: it contains exactly one zero; `open`: undecided, part of a cluster.
enum class CellVerdict { zero, open };
constexpr auto enum_names(CellVerdict) { return std::to_array({"zero", "open"}); }

/// A cell (triangle in the plane, vertices counter-clockwise) in which the search ended.
struct CertificateCell {
  int elem = 0;
  std::array<double, 6> vertices{};  ///< x0, y0, x1, y1, x2, y2
  CellVerdict verdict = CellVerdict::zero;
};

/// Evidence that no zero is missing: counts and cells of the search (zeros/zero_search).
struct Certificate {
  int elements = 0;                  ///< of the mesh, all searched
  double cells_examined = 0;         ///< whole numbers
  double cells_excluded = 0;         ///< proved to contain no zero
  double cells_isolated = 0;         ///< proved to contain at most one
  double cells_left_to_corners = 0;  ///< inside `corner_discs`: zeros there belong to the corner's valence
  int greatest_depth = 0;            ///< greatest number of bisections of an element
  std::vector<CertificateCell> cells;
  std::vector<Vec2> disc_centres;
  std::vector<double> disc_radii;
};

struct CriticalPoints {
  Provenance provenance;
  NodeForm form = NodeForm::harmonic;
  std::vector<CriticalPoint> critical_points;
  std::vector<Corner> corners;  ///< every joint with is_corner, in the order of the joints
  std::vector<IrregularBoundaryPoint> boundary_nodes;
  std::vector<int> hole_winding_offsets;  ///< added to the winding of least energy, one per hole; empty: none
  int index_sum = 0;                      ///< sum (4 - V) + sum (2 - V)
  int index_sum_expected = 0;             ///< 4 chi
  Vec2 origin;                            ///< positions are relative to it (formats/cad-face.md)

  CadFace face;  ///< without curves: unknown; no stage needs it, it is for pictures of the nodes alone

  std::vector<CriticalPoint> zeros;  ///< of the field as found, if critical_points differs from them; else empty
  std::vector<Cluster> clusters;
  std::vector<NodeChange> changes;
  Certificate certificate;
};

/// sum (4 - V) over the nodes plus sum (2 - V) over corners and boundary nodes, clamped to the limits of int for
/// damaged files.
inline int index_sum_of(const CriticalPoints& points) {
  long long sum = 0;
  for (const CriticalPoint& p : points.critical_points) sum += 4LL - p.valence;
  for (const Corner& c : points.corners) sum += 2LL - c.valence;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) sum += 2LL - b.valence;
  using Limits = std::numeric_limits<int>;
  return static_cast<int>(std::clamp<long long>(sum, Limits::min(), Limits::max()));
}

/// The nodes and valences prescribed for the phase form.
inline PhaseNodes phase_nodes_of(const CriticalPoints& points) {
  PhaseNodes nodes;
  for (const CriticalPoint& p : points.critical_points) nodes.nodes.push_back({p.position, p.valence});
  for (const Corner& c : points.corners) nodes.corners.push_back({c.joint, c.valence});
  for (const IrregularBoundaryPoint& b : points.boundary_nodes)
    nodes.boundary_nodes.push_back({b.curve, b.t, b.valence});
  return nodes;
}

}  // namespace quadrille
