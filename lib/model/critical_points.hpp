#pragma once
// The irregular nodes that a layout shall have and the valences of corners (formats/critical-points.md, x.crit.json).
// Valence V = 4 - index for an interior node; at a corner or boundary node V counts the blocks in its sector.
//
// The nodes are the guiding field's own zeros, or what was made of them: clusters resolved, nodes absorbed by corners,
// put onto the boundary, moved, asked for by hand. `form` says which: "harmonic", every node is a zero of the field
// and every corner has the valence that the field gives it; "phase", later stages need fieldsolve --nodes.

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

struct CriticalPoint {
  Vec2 position;
  int index = 0;
  int valence = 4;
  int elem = 0;                      ///< element of the field's mesh that holds it
  Vec2 xi;                           ///< reference coordinates there
  std::array<double, 4> jacobian{};  ///< d v / d x at the point: u_x, u_y, v_x, v_y; zeros where it is no zero of v
  double error = 0;                  ///< error bar |J^-1 e| of the position, e the field's error there; 0: unknown
  std::string source =
      "zero";  ///< where it comes from: "zero" of the field, put in by "hand", else the kind of a NodeChange
};

struct Corner {
  int joint = 0;  ///< index into face.joints
  Vec2 position;
  double angle_degrees = 0;
  int valence = 2;
  std::array<int, 2> curves{};  ///< incoming and outgoing
  std::string source =
      "angle";  ///< of the valence: the nearest to the "angle", the "field" at a tie, else a NodeChange
};

/// A node on the boundary where no corner is: V blocks meet there instead of 2.
struct IrregularBoundaryPoint {
  int curve = 0;
  double t = 0;  ///< parameter, inside the curve or at a smooth joint
  Vec2 position;
  int valence = 3;
  std::string source = "feature";
};

/// A node before or after a change.
struct NodeMark {
  Vec2 position;
  int valence = 4;
  std::string where = "inside";  ///< "inside", "corner" or "boundary"
};

/// One thing done to the field's own zeros and valences, and why. The index sum of `before` and `after` is the same.
struct NodeChange {
  std::string kind;    ///< "cluster", "cancel", "absorb", "corner", "line", "divide", "feature", "place"
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
  std::string form = "harmonic";  ///< "harmonic" or "phase"
  std::vector<CriticalPoint> critical_points;
  std::vector<Corner> corners;  ///< every joint with is_corner, in the sequence of the joints
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

/// What the phase form is asked for.
inline PhaseNodes phase_nodes_of(const CriticalPoints& points) {
  PhaseNodes asked;
  for (const CriticalPoint& p : points.critical_points) asked.nodes.push_back({p.position, p.valence});
  for (const Corner& c : points.corners) asked.corners.push_back({c.joint, c.valence});
  for (const IrregularBoundaryPoint& b : points.boundary_nodes)
    asked.boundary_nodes.push_back({b.curve, b.t, b.valence});
  return asked;
}

}  // namespace quadrille
