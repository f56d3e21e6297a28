#pragma once
// The irregular nodes that a layout shall have and the valences of corners (formats/critical-points.md, x.crit.json).
// Valence V = 4 - index for an interior node; at a corner or boundary node V counts the blocks in its sector.
//
// The nodes are the guiding field's own zeros, or what was made of them: clusters resolved, nodes absorbed by corners,
// put onto the boundary, moved, prescribed by hand. `form` says which.

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <vector>

#include "base/enum_names.hpp"
#include "base/vec2.hpp"
#include "model/phase_nodes.hpp"
#include "model/provenance.hpp"

namespace quadrille {

/// Which field has these nodes: every node is a zero of the harmonic field and every corner has the valence that it
/// gives; or later stages need a field of the phase form, made for them (fieldsolve --nodes).
enum class NodeForm { harmonic, phase };
constexpr auto enum_names(NodeForm) {
  return std::to_array<EnumName<NodeForm>>({{NodeForm::harmonic, "harmonic"}, {NodeForm::phase, "phase"}});
}

/// What was done to nodes and valences. `other`: a kind that a later version of the format added.
enum class ChangeKind { cluster, cancel, absorb, corner, line, divide, feature, place, other };
constexpr auto enum_names(ChangeKind) {
  return std::to_array<EnumName<ChangeKind>>({{ChangeKind::cluster, "cluster"},
                                              {ChangeKind::cancel, "cancel"},
                                              {ChangeKind::absorb, "absorb"},
                                              {ChangeKind::corner, "corner"},
                                              {ChangeKind::line, "line"},
                                              {ChangeKind::divide, "divide"},
                                              {ChangeKind::feature, "feature"},
                                              {ChangeKind::place, "place"},
                                              {ChangeKind::other, "other"}});
}

/// Where a node or a valence comes from: a `zero` of the field or `hand` (nodes), the nearest valence to the `angle` or
/// the `field` at a tie (corners), else the last change.
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
  return std::to_array<EnumName<NodeSource>>({{NodeSource::zero, "zero"},
                                              {NodeSource::hand, "hand"},
                                              {NodeSource::angle, "angle"},
                                              {NodeSource::field, "field"},
                                              {NodeSource::cluster, "cluster"},
                                              {NodeSource::cancel, "cancel"},
                                              {NodeSource::absorb, "absorb"},
                                              {NodeSource::corner, "corner"},
                                              {NodeSource::line, "line"},
                                              {NodeSource::divide, "divide"},
                                              {NodeSource::feature, "feature"},
                                              {NodeSource::place, "place"},
                                              {NodeSource::other, "other"}});
}

/// The source of a node that a change of this kind made: the one of the same name.
constexpr NodeSource source_of(ChangeKind kind) {
  switch (kind) {
    case ChangeKind::cluster:
      return NodeSource::cluster;
    case ChangeKind::cancel:
      return NodeSource::cancel;
    case ChangeKind::absorb:
      return NodeSource::absorb;
    case ChangeKind::corner:
      return NodeSource::corner;
    case ChangeKind::line:
      return NodeSource::line;
    case ChangeKind::divide:
      return NodeSource::divide;
    case ChangeKind::feature:
      return NodeSource::feature;
    case ChangeKind::place:
      return NodeSource::place;
    case ChangeKind::other:
      break;
  }
  return NodeSource::other;
}

enum class NodeLocation { inside, corner, boundary };
constexpr auto enum_names(NodeLocation) {
  return std::to_array<EnumName<NodeLocation>>(
      {{NodeLocation::inside, "inside"}, {NodeLocation::corner, "corner"}, {NodeLocation::boundary, "boundary"}});
}

struct CriticalPoint {
  Vec2 position;
  int index = 0;
  int valence = 4;
  int elem = 0;                      ///< element of the field's mesh that holds it
  Vec2 xi;                           ///< reference coordinates there
  std::array<double, 4> jacobian{};  ///< d v / d x at the point: u_x, u_y, v_x, v_y; zeros where it is no zero of v
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

/// A node on the boundary where no corner is: V blocks meet there instead of 2.
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

/// One thing done to the field's own zeros and valences, and why. The index sum of `before` and `after` is the same.
struct NodeChange {
  ChangeKind kind = ChangeKind::other;
  std::string reason;  ///< a sentence for people
  std::vector<NodeMark> before, after;
};

/// Zeros that belong together: a multiple zero, or zeros nearer to each other than any block could be.
struct Cluster {
  Vec2 centre;
  double radius = 0;  ///< of a circle about all members
  int index = 0;      ///< of them all
  std::vector<Vec2> members;
  std::vector<int> member_indices;  ///< empty where they cannot be told apart
};

/// What the search could prove of a cell: it holds exactly one zero, or nothing (it is part of a cluster).
enum class CellVerdict { zero, open };
constexpr auto enum_names(CellVerdict) {
  return std::to_array<EnumName<CellVerdict>>({{CellVerdict::zero, "zero"}, {CellVerdict::open, "open"}});
}

/// A cell (triangle in the plane, vertices counter-clockwise) in which the search ended.
struct CertificateCell {
  int elem = 0;
  std::array<double, 6> vertices{};  ///< x0, y0, x1, y1, x2, y2
  CellVerdict verdict = CellVerdict::zero;
};

/// That no zero is missing: what the search for them did (zeros/zero_search).
struct Certificate {
  int elements = 0;                  ///< all of the mesh were searched
  double cells_examined = 0;         ///< whole numbers
  double cells_excluded = 0;         ///< proved to hold no zero
  double cells_isolated = 0;         ///< proved to hold at most one
  double cells_left_to_corners = 0;  ///< within `corner_discs`: what is there belongs to the corner's valence
  int greatest_depth = 0;            ///< of halvings of an element
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
  std::vector<int> hole_winding_offsets;  ///< added to the winding of least energy, one for each hole; empty: none
  int index_sum = 0;                      ///< sum (4 - V) + sum (2 - V)
  int index_sum_expected = 0;             ///< 4 chi
  Vec2 origin;                            ///< positions are relative to it (formats/cad-face.md)

  std::vector<CriticalPoint> zeros;  ///< of the field as found, where critical_points differ from them; else empty
  std::vector<Cluster> clusters;
  std::vector<NodeChange> changes;
  Certificate certificate;
};

/// sum (4 - V) over the nodes and sum (2 - V) over corners and boundary nodes; a damaged file's sum ends at the limits
/// of int.
inline int index_sum_of(const CriticalPoints& points) {
  long long sum = 0;
  for (const CriticalPoint& p : points.critical_points) sum += 4LL - p.valence;
  for (const Corner& c : points.corners) sum += 2LL - c.valence;
  for (const IrregularBoundaryPoint& b : points.boundary_nodes) sum += 2LL - b.valence;
  using Limits = std::numeric_limits<int>;
  return static_cast<int>(std::clamp<long long>(sum, Limits::min(), Limits::max()));
}

/// The nodes and valences that the phase form must have.
inline PhaseNodes phase_nodes_of(const CriticalPoints& points) {
  PhaseNodes nodes;
  for (const CriticalPoint& p : points.critical_points) nodes.nodes.push_back({p.position, p.valence});
  for (const Corner& c : points.corners) nodes.corners.push_back({c.joint, c.valence});
  for (const IrregularBoundaryPoint& b : points.boundary_nodes)
    nodes.boundary_nodes.push_back({b.curve, b.t, b.valence});
  return nodes;
}

}  // namespace quadrille
