#pragma once
// The start of separatrices: the nodes that do not depend on them, and the first point of each line, a small distance
// along its launch direction, on the curve that the field prescribes.

#include <vector>

#include "base/vec2.hpp"
#include "field/evaluate.hpp"
#include "graph/build_graph.hpp"
#include "model/critical_points.hpp"

namespace quadrille::trace {

/// Irregular nodes in the order of `points`, then its corners, then its boundary nodes. Throws ComputeError with the
/// position for nodes that no layout can have: degenerate corners (V = 0), nodes with V <= 2, boundary nodes with V <
/// 3.
std::vector<GraphNode> fixed_nodes(const CadFace& face, const CriticalPoints& points);

std::vector<Vec2> positions(const std::vector<GraphNode>& nodes);

/// The part of a line from its start to the point at which integration begins.
struct Launch {
  graph::LineEnd start;  ///< a node, numbered as the caller does, or a position on the boundary
  Vec2 origin;           ///< its position
  double angle = 0;      ///< direction at it, radians
  double radius = 0;
  int elem = 0;  ///< element and reference coordinates of the first point
  Vec2 xi;
  Vec2 x;                  ///< its position
  double angle_there = 0;  ///< direction there
  bool is_straight =
      false;  ///< the line keeps this direction: it is a mirror axis of the field (trace/line_tracer.hpp)
};

struct MirrorAxis {
  Vec2 point, direction;  ///< of unit length
};

/// Moves by `radius` (a length) along the direction `angle`, or by less if the point is outside the domain, on the
/// curve whose direction deviates from `angle` like distance^power: 1 at a zero of the field, pi / omega at a corner.
/// Throws ComputeError if no point of the domain lies in that direction.
Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power);

/// A line from a point of the boundary straight into the domain (cuts).
Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t);

/// V lines from each irregular node, V - 1 from each corner and boundary node; Launch::node is a position in
/// fixed_nodes. For a field of kind "phase" the nodes of `points` must be those of the field, in its order
/// (field/check_nodes_match_field). Throws ComputeError as fixed_nodes and launch_line.
std::vector<Launch> launch_all(const field::FieldEvaluator& evaluator, const CriticalPoints& points);

/// Number of lines that launch_all launches.
int num_launches(const CriticalPoints& points);

/// Four lines from the inner loop of a domain between two loops, at equal fractions of its length from the start of its
/// first curve, or as near to that as they are symmetric by one of the axes.
std::vector<Launch> launch_cuts(const field::FieldEvaluator& evaluator, const std::vector<MirrorAxis>& axes);

}  // namespace quadrille::trace
