#pragma once
// The first point of a separatrix: a small distance along its launch direction, on the curve that the field prescribes.

#include "base/vec2.hpp"
#include "field/evaluate.hpp"

namespace quadrille::trace {

/// The part of a line from its node to the point at which integration begins.
struct Launch {
  int node = 0;      ///< the node it starts at, numbered as the caller does; -1: it starts on the boundary
  Vec2 origin;       ///< the node's position
  double angle = 0;  ///< direction at the node, radians
  double radius = 0;
  int elem = 0;  ///< element and reference coordinates of the first point
  Vec2 xi;
  Vec2 x;                  ///< its position
  double angle_there = 0;  ///< direction there
  int curve = -1;          ///< for a line that starts on the boundary: CAD curve and parameter
  double t = 0;
};

/// Moves by `radius` (a length) along the direction `angle`, or by less if the point is outside the domain, on the
/// curve whose direction deviates from `angle` like distance^power: 1 at a zero of the field, pi / omega at a corner.
/// Throws ComputeError if no point of the domain lies in that direction.
Launch launch_line(const field::FieldEvaluator& evaluator, int node, Vec2 origin, double angle, double radius,
                   double power);

/// A line from a point of the boundary straight into the domain (cuts).
Launch launch_from_boundary(const field::FieldEvaluator& evaluator, int curve, double t);

}  // namespace quadrille::trace
