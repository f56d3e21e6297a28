#pragma once
// The layouts of the regions of a face, each of its own, before they are joined; and points of the boundaries of the
// regions, and which of them are one point of the plane.
//
// A curve that two regions share is there twice (model/cad_face.hpp), so a point of it is two boundary points, one on
// each curve; a junction of three regions is three joints. Each boundary point is one sector about the point of the
// plane: the region that it bounds there.

#include <compare>
#include <vector>

#include "field/evaluate.hpp"
#include "graph/candidate_layout.hpp"
#include "model/cad_face.hpp"

namespace quadrille::couple {

/// Relative to the diameter: nodes on an interface or on periodic sides that are nearer than this are one.
inline constexpr double relative_same = 1e-8;

/// A point of a curve, not its end: that is the start of the next curve in the loop.
struct BoundaryPoint {
  int curve = 0;
  double t = 0;

  auto operator<=>(const BoundaryPoint&) const = default;
  bool is_joint(const CadFace& face) const { return t == face.curves[curve].begin(); }
  /// At a joint exactly that of the joint.
  Vec2 position(const CadFace& face) const;
};

/// The point with a parameter, which may be that of the curve's end.
BoundaryPoint boundary_point(const CadFace& face, int curve, double t);

/// The point of a loop that is nearest to a position; a joint within 1e-9 diameters of it.
BoundaryPoint nearest_boundary_point(const CadFace& face, int loop, Vec2 position);

/// The point on `partner` of a point of another curve: its partner across an interface, or its periodic image.
BoundaryPoint opposite_point(const CadFace& face, const BoundaryPoint& point, int partner);

/// All boundary points that are one point of the plane, counter-clockwise about it. If it is inside the whole, from the
/// lowest one on; if it is on the boundary of the whole, from the one whose outgoing curve is of that boundary on.
std::vector<BoundaryPoint> coincident_points(const CadFace& face, const BoundaryPoint& point);

/// Whether regions surround the point.
bool is_inside_whole(const CadFace& face, const BoundaryPoint& point);

struct RegionLayouts {
  CadFace face;                                 ///< the whole
  std::vector<graph::CandidateLayout> layouts;  ///< one for each region; their faces are those of regions/split.hpp
  std::vector<const field::FieldEvaluator*> fields;  ///< one for each region
  std::vector<int> first_curves;                     ///< number in the whole of the first curve of each region
  std::vector<curve::Rotation> rotations = {};       ///< of circular regions, by region; empty: none was rotated

  curve::Rotation rotation_of(int region) const { return rotations.empty() ? curve::Rotation{} : rotations[region]; }
  field::FieldsOfRegions field_of(int region) const {
    return field::FieldsOfRegions({fields[region]}, {rotation_of(region)});
  }
  int region_of_curve(int curve) const { return face.region_of_loop(face.loop_of(curve)); }
  /// The point of the whole at which a node of a region's graph lies that is on the boundary of the region.
  BoundaryPoint point_of(int region, int node) const {
    const GraphNode& n = layouts[region].graph().nodes[node];
    return boundary_point(face, n.curve + first_curves[region], n.t);
  }

  /// The kinds of the lines of the splines of each layout.
  std::vector<std::vector<LineKind>> line_kinds() const;
  /// Sets the lines of the layouts after their arcs changed. `kinds`: before the change; new lines are of kind `added`.
  void rebuild_lines(std::vector<std::vector<LineKind>> kinds, LineKind added);
};

}  // namespace quadrille::couple
