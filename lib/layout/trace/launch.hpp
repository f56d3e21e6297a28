#pragma once
// The first point of a separatrix: a small distance along its launch direction, on the curve that the field prescribes.

#include "base/vec2.hpp"
#include "field/evaluate.hpp"
#include "graph/build_graph.hpp"

namespace quadrille::trace {

/// The part of a line from its start to the point at which integration begins.
struct Launch {
  graph::LineEnd start;  ///< a node, numbered as the caller does, or a position on the boundary
  Vec2 origin;           ///< its position
  double angle = 0;      ///< direction at it, radians
  double radius = 0;
  int elem = 0;  ///< element and reference coordinates of the first point
  Vec2 xi;
  Vec2 x;                    ///< its position
  double angle_there = 0;    ///< direction there
  bool is_straight = false;  ///< the line keeps this direction: it is a mirror axis of the field (trace/mirror_axes)
};

/// Moves by `radius` (a length) along the direction `angle`, or by less if the point is outside the domain, on the
/// curve whose direction deviates from `angle` like distance^power: 1 at a zero of the field, pi / omega at a corner.
/// Throws ComputeError if no point of the domain lies in that direction.
Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power);

/// A line from a point of the boundary straight into the domain (cuts).
Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t);

}  // namespace quadrille::trace
